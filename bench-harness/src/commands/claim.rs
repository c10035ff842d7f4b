//! Hulls made by anyone, read from their files.
//!
//! In the plane a claim is a list of indices, of points from 0, in order round the hull: a CSV file with a column
//! `index` (as this program writes it), or one whose first field is the index. In space it is a mesh, whose points
//! are matched to the input by their exact coordinates; a copy of a point stands for the copy with the smallest index.
//! A JSON file of this program is either.

use crate::claimed::{self, key, smallest_copies};
use crate::commands::input::Input;
use crate::failure::Failure;
use geometry_core::{Hull2, Hull3};
use point_sets::mesh_file::{PolygonMesh, read_mesh};
use serde::Deserialize;
use std::collections::HashMap;
use std::fs;
use std::path::Path;

/// What a JSON file of a hull holds that matters here.
#[derive(Deserialize)]
struct Json {
    vertices: Vec<JsonVertex>,
    #[serde(default)]
    facets: Vec<Vec<u32>>,
}

#[derive(Deserialize)]
struct JsonVertex {
    index: u32,
    x: f64,
    y: f64,
    #[serde(default)]
    z: f64,
}

/// The hull of points of the plane that the file `path` claims.
///
/// # Errors
///
/// [`Failure::Data`] for a file that is no list of indices, [`Failure::Io`] for one that cannot be read.
pub fn in_plane(path: &Path, input: &Input) -> Result<Hull2, Failure> {
    let ids = match extension(path).as_str() {
        "json" => read_json(path)?.vertices.iter().map(|v| v.index).collect(),
        _ => read_indices(path)?,
    };
    Ok(as_hull2(input, ids))
}

/// The value that the cycle `ids` stands for, each id the smallest of its copies.
fn as_hull2(input: &Input, mut ids: Vec<u32>) -> Hull2 {
    let smallest = smallest_copies(&input.points);
    for id in &mut ids {
        if let Some(point) = input.points.get(*id as usize) {
            *id = smallest[&key(*point)];
        }
    }
    claimed::planar(input.view(), ids)
}

/// The hull of points of space that the file `path` claims; `Err` inside with what is wrong with it before any
/// geometry: vertices that are none of the points.
///
/// # Errors
///
/// [`Failure::Data`] for a file that is no mesh, [`Failure::Io`] for one that cannot be read.
pub fn in_space(path: &Path, input: &Input<3>) -> Result<Result<Hull3, Vec<String>>, Failure> {
    let mesh = match extension(path).as_str() {
        "json" => mesh_of(path, &read_json(path)?)?,
        _ => read_mesh(path)?,
    };
    let smallest = smallest_copies(&input.points);
    let mut findings = Vec::new();
    let matched = mesh.points.iter().enumerate().map(|(vertex, point)| {
        let id = smallest.get(&key(*point)).copied();
        if id.is_none() {
            let [x, y, z] = point;
            findings.push(format!(
                "vertex {vertex} of the file, ({x:?}, {y:?}, {z:?}), is none of the points"
            ));
        }
        id
    });
    let matched: Vec<Option<u32>> = matched.collect();
    // Points of the mesh on no polygon do not matter, as long as there are polygons.
    let Some(matched) = matched.into_iter().collect::<Option<Vec<u32>>>() else {
        return Ok(Err(findings));
    };
    Ok(Ok(as_hull3(input, &mesh, &matched)))
}

/// The value that a mesh stands for whose points are the points `ids`.
fn as_hull3(input: &Input<3>, mesh: &PolygonMesh, ids: &[u32]) -> Hull3 {
    let polygon =
        |corners: &Vec<u32>| -> Vec<u32> { corners.iter().map(|&c| ids[c as usize]).collect() };
    claimed::spatial(
        input.view(),
        ids,
        mesh.polygons.iter().map(polygon).collect(),
    )
}

fn extension(path: &Path) -> String {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension.unwrap_or_default().to_ascii_lowercase()
}

fn mesh_of(path: &Path, json: &Json) -> Result<PolygonMesh, Failure> {
    let places: HashMap<u32, u32> = json.vertices.iter().map(|v| v.index).zip(0..).collect();
    let place = |id: &u32| {
        places.get(id).copied().ok_or_else(|| {
            Failure::Data(format!(
                "{}: corner {id} is none of the vertices",
                path.display()
            ))
        })
    };
    let facet = |facet: &Vec<u32>| facet.iter().map(place).collect();
    let round = [(0..json.vertices.len() as u32).collect::<Vec<u32>>()];
    let polygons = json
        .facets
        .iter()
        .map(facet)
        .collect::<Result<Vec<_>, Failure>>()?;
    let is_planar = polygons.is_empty() && json.vertices.len() > 2;
    Ok(PolygonMesh {
        points: json.vertices.iter().map(|v| [v.x, v.y, v.z]).collect(),
        polygons: if is_planar { round.to_vec() } else { polygons },
    })
}

fn read_json(path: &Path) -> Result<Json, Failure> {
    let content = fs::read(path).map_err(|error| {
        Failure::io(path.display(), &error, "check the name and the permissions")
    })?;
    serde_json::from_slice(&content).map_err(|error| {
        Failure::Data(format!(
            "{}:{}:{}: no hull: {error}; give a JSON file as `hullbench hull` writes it",
            path.display(),
            error.line(),
            error.column()
        ))
    })
}

fn read_indices(path: &Path) -> Result<Vec<u32>, Failure> {
    let content = fs::read(path).map_err(|error| {
        Failure::io(path.display(), &error, "check the name and the permissions")
    })?;
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(&content[..]);
    let mut ids = Vec::new();
    let mut column = None;
    for record in reader.records() {
        let record =
            record.map_err(|error| Failure::Data(format!("{}: {error}", path.display())))?;
        let column = match column {
            Some(column) => column,
            None => {
                let named = record
                    .iter()
                    .position(|field| field.eq_ignore_ascii_case("index"));
                column = Some(named.unwrap_or(0));
                if named.is_some() {
                    continue;
                }
                0
            }
        };
        let field = record.get(column).unwrap_or_default();
        let id = field.parse().map_err(|_| {
            let line = record.position().map_or(1, csv::Position::line);
            Failure::Data(format!(
                "{}:{line}: {field:?} is no index; list the indices of points, from 0, one a line, or in a column \
                 named index",
                path.display()
            ))
        })?;
        ids.push(id);
    }
    Ok(ids)
}
