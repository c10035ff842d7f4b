//! Plain right Delaunay triangulations: any triangulation, by a sweep, then flips (Lawson 1977).

use geometry_core::{Point2, Triangulation};
use hull_verify::arithmetic::scale::Scale;
use hull_verify::arithmetic::{Frame, Turn, order};
use std::collections::HashMap;

/// The corner to the left of each directed edge.
struct Mesh<'a> {
    points: &'a [Point2],
    frame: Frame,
    apexes: HashMap<[u32; 2], u32>,
}

impl Mesh<'_> {
    fn turn(&self, a: u32, b: u32, c: u32) -> Turn {
        let [a, b, c] = [a, b, c].map(|id| self.points[id as usize]);
        self.frame.turn(a, b, c)
    }

    fn add(&mut self, [a, b, c]: [u32; 3]) {
        for (edge, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            self.apexes.insert(edge, apex);
        }
    }

    fn remove(&mut self, [a, b, c]: [u32; 3]) {
        for edge in [[a, b], [b, c], [c, a]] {
            self.apexes.remove(&edge);
        }
    }

    fn triangulation(&self) -> Triangulation {
        let triangles = self.apexes.iter().map(|(&[a, b], &c)| [a, b, c]);
        let once = triangles.filter(|&[a, b, c]| a < b && a < c);
        Triangulation::new(once.collect())
    }

    /// The triangles abc and bad as cad and bcd, if these are not flat nor inside out.
    fn flip(&mut self, [a, b]: [u32; 2]) -> Option<[u32; 2]> {
        let (&c, &d) = (self.apexes.get(&[a, b])?, self.apexes.get(&[b, a])?);
        let fits = self.turn(c, a, d) == Turn::Left && self.turn(d, b, c) == Turn::Left;
        if fits {
            self.remove([a, b, c]);
            self.remove([b, a, d]);
            self.add([c, a, d]);
            self.add([d, b, c]);
        }
        fits.then_some([c, d])
    }
}

fn sweep(points: &[Point2]) -> Mesh<'_> {
    let mut mesh = Mesh {
        points,
        frame: Frame::of(points),
        apexes: HashMap::new(),
    };
    let at = |id: u32| points[id as usize];
    let mut ids: Vec<u32> = (0..points.len() as u32).collect();
    ids.sort_by(|&a, &b| order(at(a), at(b)).then(a.cmp(&b)));
    ids.dedup_by(|later, kept| order(at(*later), at(*kept)).is_eq());
    // The hull so far, anticlockwise from the latest point; while all are on one line, there and back.
    let mut hull: Vec<u32> = Vec::new();
    for p in ids {
        let m = hull.len();
        let edge = |i: usize| [hull[i % m], hull[(i + 1) % m]];
        let sees = |i: usize| {
            let [a, b] = edge(i);
            a != b && mesh.turn(a, b, p) == Turn::Right
        };
        // The edges that p sees are in a row.
        let Some(start) = (0..m).find(|&i| sees(i) && !sees(i + m - 1)) else {
            // On the line of all points so far: 0, 1, …, k, k - 1, …, 1 grows at its middle, which is its front here.
            hull = match hull.len() {
                0 => vec![p],
                1 => vec![p, hull[0]],
                _ => {
                    let mut longer = vec![p];
                    longer.extend(&hull);
                    longer.push(hull[0]);
                    longer
                }
            };
            continue;
        };
        let row: Vec<[u32; 2]> = (start..).take_while(|&i| sees(i)).map(edge).collect();
        for &[a, b] in &row {
            mesh.add([b, a, p]);
        }
        hull.rotate_left((start + row.len()) % m);
        hull.truncate(m - row.len() + 1);
        hull.insert(0, p);
    }
    mesh
}

/// Some triangulation.
pub(crate) fn by_sweep(points: &[Point2]) -> Triangulation {
    sweep(points).triangulation()
}

/// A Delaunay triangulation.
pub(crate) fn by_flips(points: &[Point2]) -> Triangulation {
    let scale = Scale::of(points);
    let mut mesh = sweep(points);
    let mut doubtful: Vec<[u32; 2]> = mesh.apexes.keys().copied().collect();
    doubtful.sort_unstable();
    while let Some([a, b]) = doubtful.pop() {
        let (Some(&c), Some(&d)) = (mesh.apexes.get(&[a, b]), mesh.apexes.get(&[b, a])) else {
            continue;
        };
        let [p, q, r, s] = [a, b, c, d].map(|id| points[id as usize]);
        if scale.in_circle(p, q, r, s).is_gt() && mesh.flip([a, b]).is_some() {
            doubtful.extend([[a, d], [d, b], [b, c], [c, a]]);
        }
    }
    mesh.triangulation()
}

/// All triangulations that differ by one flip.
pub(crate) fn neighbours(points: &[Point2], triangulation: &Triangulation) -> Vec<Triangulation> {
    let mut mesh = Mesh {
        points,
        frame: Frame::of(points),
        apexes: HashMap::new(),
    };
    for &triangle in triangulation.triangles() {
        mesh.add(triangle);
    }
    let mut found = Vec::new();
    for edge in triangulation.edges() {
        if let Some(flipped) = mesh.flip(edge) {
            found.push(mesh.triangulation());
            mesh.flip(flipped);
        }
    }
    found
}
