//! Changes of a point set in space under which the answer is known: reorderings, copies, exact motions.

use crate::arithmetic::scale::order3;
use crate::conformance::change::{Handedness, shuffle};
use geometry_core::hull3::Solid;
use geometry_core::{Hull3, Point3};

/// A point set made of another one.
#[derive(Clone, Debug)]
pub struct Change3 {
    /// What was done, with its seed if any.
    pub name: String,
    /// The changed points.
    pub points: Vec<Point3>,
    /// Of which original point each is the image.
    pub origin: Vec<u32>,
    /// Whether space was mirrored.
    pub handedness: Handedness,
}

impl Change3 {
    /// The points `origin`, unmoved.
    fn picked(name: String, points: &[Point3], origin: Vec<u32>) -> Self {
        Self {
            name,
            points: origin.iter().map(|&id| points[id as usize]).collect(),
            origin,
            handedness: Handedness::Kept,
        }
    }

    /// The index that stands for the image of each original point: the smallest of all copies of it.
    fn standing_for(&self) -> Vec<u32> {
        let at = |id: u32| self.points[id as usize];
        let mut sorted: Vec<u32> = (0..self.points.len() as u32).collect();
        sorted.sort_by(|&a, &b| order3(at(a), at(b)).then(a.cmp(&b)));
        // Every original point has an image, so no entry stays as it is.
        let mut standing = vec![u32::MAX; self.points.len()];
        for copies in sorted.chunk_by(|&a, &b| order3(at(a), at(b)).is_eq()) {
            for &copy in copies {
                standing[self.origin[copy as usize] as usize] = copies[0];
            }
        }
        standing
    }
}

/// The right answer for the changed points, where `hull` is right for the original ones.
pub fn carried(hull: &Hull3, change: &Change3) -> Hull3 {
    let standing = change.standing_for();
    let new = |&id: &u32| standing[id as usize];
    let at = |id: u32| change.points[id as usize];
    match hull {
        Hull3::Empty => Hull3::Empty,
        Hull3::Point(id) => Hull3::Point(new(id)),
        Hull3::Segment(ends) => {
            let mut ends = [new(&ends[0]), new(&ends[1])];
            ends.sort_by(|&a, &b| order3(at(a), at(b)));
            Hull3::Segment(ends)
        }
        Hull3::Planar(ids) => {
            let mut cycle: Vec<u32> = ids.iter().map(new).collect();
            let first = (0..cycle.len()).min_by(|&i, &j| order3(at(cycle[i]), at(cycle[j])));
            cycle.rotate_left(first.unwrap_or(0));
            if order3(at(cycle[cycle.len() - 1]), at(cycle[1])).is_lt() {
                cycle[1..].reverse();
            }
            Hull3::Planar(cycle)
        }
        Hull3::Solid(solid) => {
            let facet = |facet: &[u32]| {
                let mut corners: Vec<u32> = facet.iter().map(new).collect();
                if change.handedness == Handedness::Mirrored {
                    corners.reverse();
                }
                corners
            };
            Hull3::Solid(Solid::from_loops(solid.facets().map(facet).collect()))
        }
    }
}

/// The changes that the suite makes of every set.
pub fn all(points: &[Point3], seed: u64) -> Vec<Change3> {
    let mut changes = reorderings(points, seed);
    changes.extend(copies(points, seed));
    changes.extend(symmetries(points));
    changes.extend(scalings(points));
    changes
}

/// The points in ten other orders.
pub fn reorderings(points: &[Point3], seed: u64) -> Vec<Change3> {
    let ids = || 0..points.len() as u32;
    let mut sorted: Vec<u32> = ids().collect();
    sorted.sort_by(|&a, &b| order3(points[a as usize], points[b as usize]));
    let mut middle_first: Vec<u32> = ids().collect();
    middle_first.rotate_left(points.len() / 2);
    let shuffled = |seed: u64| {
        let mut origin: Vec<u32> = ids().collect();
        shuffle(&mut origin, seed);
        Change3::picked(format!("shuffled with seed {seed}"), points, origin)
    };
    let mut changes = vec![
        Change3::picked("reversed".into(), points, ids().rev().collect()),
        Change3::picked("sorted".into(), points, sorted.clone()),
        Change3::picked("rotated".into(), points, middle_first),
        Change3::picked(
            "sorted, reversed".into(),
            points,
            sorted.into_iter().rev().collect(),
        ),
    ];
    changes.extend((0..6).map(|i| shuffled(1000 * i + seed)));
    changes
}

fn copies(points: &[Point3], seed: u64) -> Vec<Change3> {
    let ids = || 0..points.len() as u32;
    let twice: Vec<u32> = ids().chain(ids().rev()).collect();
    let mut mixed = twice.clone();
    shuffle(&mut mixed, seed);
    vec![
        Change3::picked("twice".into(), points, twice),
        Change3::picked(
            "each with a copy behind it".into(),
            points,
            ids().flat_map(|id| [id, id]).collect(),
        ),
        Change3::picked(format!("twice, shuffled with seed {seed}"), points, mixed),
    ]
}

/// Symmetries of the cube, exact on every set: axes permuted, then signs changed.
fn symmetries(points: &[Point3]) -> Vec<Change3> {
    let permutations = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [1, 0, 2],
        [0, 2, 1],
        [2, 1, 0],
    ];
    let signs = [
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, -1.0, -1.0],
    ];
    let mut changes = Vec::new();
    for (number, axes) in permutations.into_iter().enumerate() {
        for sign in signs {
            // The permutations from the fourth on are transpositions, which mirror space; so does an odd number of signs.
            let mirrors = usize::from(number >= 3) + sign.iter().filter(|&&s| s < 0.0).count();
            changes.push(Change3 {
                name: format!("axes {axes:?} times {sign:?}"),
                points: points
                    .iter()
                    .map(|p| [0, 1, 2].map(|i| sign[i] * p[axes[i]]))
                    .collect(),
                origin: (0..points.len() as u32).collect(),
                handedness: if mirrors % 2 == 1 {
                    Handedness::Mirrored
                } else {
                    Handedness::Kept
                },
            });
        }
    }
    // The first changes nothing.
    changes.remove(0);
    changes
}

/// By powers of two, where no coordinate overflows or loses a bit.
fn scalings(points: &[Point3]) -> Vec<Change3> {
    [-900, -30, 1, 30, 900]
        .into_iter()
        .filter_map(|exponent| {
            let (by, back) = (2.0_f64.powi(exponent), 2.0_f64.powi(-exponent));
            let scaled: Vec<Point3> = points.iter().map(|p| p.map(|x| x * by)).collect();
            let exact = scaled
                .iter()
                .zip(points)
                .all(|(s, p)| s.map(|x| x * back) == *p);
            exact.then(|| Change3 {
                name: format!("scaled by 2^{exponent}"),
                points: scaled,
                origin: (0..points.len() as u32).collect(),
                handedness: Handedness::Kept,
            })
        })
        .collect()
}
