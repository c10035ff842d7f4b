//! The crates, each called as its documentation says.

use crate::protocol::{Call, Engine, Hull, Vertex, Way};
use geo::algorithm::convex_hull::{graham_hull, quick_hull};
use geo::{Coord, LineString};
use spade::{DelaunayTriangulation, Point2, Triangulation};
use std::collections::HashMap;

const PLANE: &[&str] = &["hull2"];
const DELAUNAY: &[&str] = &["delaunay"];

/// The engine `name`.
pub fn engine(name: &str) -> Option<Box<dyn Engine>> {
    Some(match name {
        "geo-quick-hull" => geo(|mut points| Ok(quick_hull(&mut points))),
        "geo-graham-hull" => geo(|mut points| Ok(graham_hull(&mut points, false))),
        "parry2d" => Box::new(Call::new(
            &["parry2d-f64"],
            PLANE,
            |points| {
                points
                    .rows()
                    .map(|p| parry2d_f64::math::Vector::new(p[0], p[1]))
                    .collect()
            },
            Way::Reads(|points: &Vec<_>| Ok(parry2d_f64::transformation::convex_hull_idx(points))),
            |ids, _| cycle(ids.iter().map(|&id| Vertex::Index(id))),
        )),
        "parry3d" => Box::new(Call::new(
            &["parry3d-f64"],
            &["hull3"],
            |points| {
                points
                    .rows()
                    .map(|p| parry3d_f64::math::Vector::new(p[0], p[1], p[2]))
                    .collect()
            },
            Way::Reads(|points: &Vec<_>| {
                let hull = parry3d_f64::transformation::try_convex_hull(points);
                hull.map_err(|error| error.to_string())
            }),
            |(vertices, triangles), _| {
                let at = |id: u32| {
                    let p = vertices[id as usize];
                    Vertex::At([p.x, p.y, p.z])
                };
                triangulation(triangles.iter().map(|triangle| triangle.map(at)))
            },
        )),
        "chull" => Box::new(Call::new(
            &["chull"],
            &["hull2", "hull3"],
            |points| points.rows().map(<[f64]>::to_vec).collect(),
            Way::Reads(|points: &Vec<_>| {
                let hull = chull::ConvexHull::try_new(points, f64::EPSILON, None);
                hull.map_err(|error| format!("{error:?}"))
            }),
            read_chull,
        )),
        "spade" => Box::new(Call::new(
            &["spade"],
            DELAUNAY,
            |points| points.rows().map(|p| Point2::new(p[0], p[1])).collect(),
            Way::Consumes(|points: Vec<_>| {
                let done = DelaunayTriangulation::<Point2<f64>>::bulk_load(points);
                done.map_err(|error| error.to_string())
            }),
            |result, _| {
                let at = |p: Point2<f64>| Vertex::At([p.x, p.y, 0.0]);
                triangulation(result.inner_faces().map(|face| face.positions().map(at)))
            },
        )),
        "delaunator" => Box::new(Call::new(
            &["delaunator"],
            DELAUNAY,
            |points| {
                points
                    .rows()
                    .map(|p| delaunator::Point { x: p[0], y: p[1] })
                    .collect()
            },
            Way::Reads(|points: &Vec<_>| Ok(delaunator::triangulate(points))),
            // Its y runs down: what it calls anticlockwise is clockwise.
            |result, _| {
                let triangles = result.triangles.chunks(3);
                triangulation(triangles.map(|t| [t[0], t[2], t[1]].map(Vertex::Index)))
            },
        )),
        _ => return None,
    })
}

/// The functions of geo reorder their input.
fn geo(function: fn(Vec<Coord>) -> Result<LineString, String>) -> Box<dyn Engine> {
    Box::new(Call::new(
        &["geo"],
        PLANE,
        |points| points.rows().map(|p| Coord { x: p[0], y: p[1] }).collect(),
        Way::Consumes(function),
        // A ring says its first vertex again at its end.
        |ring, _| {
            let open = if ring.is_closed() {
                &ring.0[..ring.0.len().saturating_sub(1)]
            } else {
                &ring.0
            };
            cycle(open.iter().map(|c| Vertex::At([c.x, c.y, 0.0])))
        },
    ))
}

/// Its facets are edges in the plane, triangles in space.
fn read_chull(hull: &chull::ConvexHull<f64>, task: &str) -> Hull {
    let (vertices, ids) = hull.vertices_indices();
    let at = |id: usize| {
        let at = |axis| vertices[id].get(axis).copied().unwrap_or(0.0);
        Vertex::At([at(0), at(1), at(2)])
    };
    if task == "hull3" {
        return triangulation(ids.chunks(3).map(|t| [t[0], t[1], t[2]].map(at)));
    }
    let next: HashMap<usize, usize> = ids.chunks(2).map(|edge| (edge[0], edge[1])).collect();
    let mut round = Vec::new();
    let mut here = ids.first().copied();
    while let Some(id) = here.filter(|_| round.len() < next.len()) {
        round.push(id);
        here = next.get(&id).copied();
    }
    cycle(round.into_iter().map(at))
}

fn cycle(vertices: impl Iterator<Item = Vertex>) -> Hull {
    Hull {
        kind: "cycle",
        parts: vec![vertices.collect()],
    }
}

fn triangulation(triangles: impl Iterator<Item = [Vertex; 3]>) -> Hull {
    Hull {
        kind: "triangles",
        parts: triangles.map(Vec::from).collect(),
    }
}
