//! Changes of a point set under which the answer is known: reorderings, copies, exact motions.

use crate::arithmetic::order;
use geometry_core::Point2;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Whether a change keeps left and right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handedness {
    /// Anticlockwise stays anticlockwise.
    Kept,
    /// Anticlockwise becomes clockwise.
    Mirrored,
}

/// A point set made of another one.
#[derive(Clone, Debug)]
pub struct Change {
    /// What was done, with its seed if any.
    pub name: String,
    /// The changed points.
    pub points: Vec<Point2>,
    /// Of which original point each is the image.
    pub origin: Vec<u32>,
    /// Whether the plane was mirrored.
    pub handedness: Handedness,
}

impl Change {
    /// The points in reverse order.
    pub fn reversed(points: &[Point2]) -> Self {
        Self::picked("reversed".into(), points, ids(points).rev().collect())
    }

    /// The points in random order.
    pub fn shuffled(points: &[Point2], seed: u64) -> Self {
        let mut origin: Vec<u32> = ids(points).collect();
        shuffle(&mut origin, seed);
        Self::picked(format!("shuffled with seed {seed}"), points, origin)
    }

    /// The index that stands for the image of the original point `id`: the smallest of all its copies.
    pub fn stands_for(&self, id: u32) -> u32 {
        let image = self
            .origin
            .iter()
            .position(|&old| old == id)
            .map(|i| self.points[i]);
        let copy_of_image = |p: &Point2| image.is_some_and(|image| order(image, *p).is_eq());
        // Every original point has an image, so there is one; u32::MAX would be no point of the set.
        self.points
            .iter()
            .position(copy_of_image)
            .map_or(u32::MAX, |i| i as u32)
    }

    /// The points `origin`, unmoved.
    fn picked(name: String, points: &[Point2], origin: Vec<u32>) -> Self {
        Self {
            name,
            points: origin.iter().map(|&id| points[id as usize]).collect(),
            origin,
            handedness: Handedness::Kept,
        }
    }

    /// Every point moved by `motion`, unless that is inexact for one of them: then `back` does not restore it.
    fn moved(
        name: &str,
        points: &[Point2],
        handedness: Handedness,
        motion: impl Fn(Point2) -> Point2,
        back: impl Fn(Point2) -> Point2,
    ) -> Option<Self> {
        let moved: Vec<Point2> = points.iter().map(|&p| motion(p)).collect();
        let exact = moved.iter().zip(points).all(|(&m, &p)| back(m) == p);
        exact.then(|| Self {
            name: name.into(),
            points: moved,
            origin: ids(points).collect(),
            handedness,
        })
    }
}

/// The changes that the suite makes of every set.
pub fn all(points: &[Point2], seed: u64) -> Vec<Change> {
    let mut changes = reorderings(points, seed);
    changes.extend(copies(points, seed));
    changes.extend(symmetries(points));
    changes.extend(scalings(points));
    changes.extend(translations(points));
    changes
}

fn reorderings(points: &[Point2], seed: u64) -> Vec<Change> {
    let mut sorted: Vec<u32> = ids(points).collect();
    sorted.sort_by(|&a, &b| order(points[a as usize], points[b as usize]));
    let mut middle_first: Vec<u32> = ids(points).collect();
    middle_first.rotate_left(points.len() / 2);
    let mut changes = vec![
        Change::reversed(points),
        Change::picked("sorted".into(), points, sorted),
        Change::picked("rotated".into(), points, middle_first),
    ];
    changes.extend((0..3).map(|i| Change::shuffled(points, 1000 * i + seed)));
    changes
}

fn copies(points: &[Point2], seed: u64) -> Vec<Change> {
    let twice: Vec<u32> = ids(points).chain(ids(points)).collect();
    let paired: Vec<u32> = ids(points).flat_map(|id| [id, id]).collect();
    let mut mixed = twice.clone();
    shuffle(&mut mixed, seed);
    vec![
        Change::picked("twice".into(), points, twice),
        Change::picked("each with a copy behind it".into(), points, paired),
        Change::picked(format!("twice, shuffled with seed {seed}"), points, mixed),
    ]
}

/// The motions of the square: exact on every set.
fn symmetries(points: &[Point2]) -> Vec<Change> {
    use Handedness::{Kept, Mirrored};
    type Motion = fn(Point2) -> Point2;
    let motions: [(&str, Handedness, Motion, Motion); 5] = [
        (
            "mirrored left to right",
            Mirrored,
            |[x, y]| [-x, y],
            |[x, y]| [-x, y],
        ),
        (
            "mirrored top to bottom",
            Mirrored,
            |[x, y]| [x, -y],
            |[x, y]| [x, -y],
        ),
        ("axes exchanged", Mirrored, |[x, y]| [y, x], |[x, y]| [y, x]),
        ("half a turn", Kept, |[x, y]| [-x, -y], |[x, y]| [-x, -y]),
        ("a quarter turn", Kept, |[x, y]| [-y, x], |[x, y]| [y, -x]),
    ];
    motions
        .into_iter()
        .filter_map(|(name, handedness, motion, back)| {
            Change::moved(name, points, handedness, motion, back)
        })
        .collect()
}

/// By powers of two, where no coordinate overflows or loses a bit.
fn scalings(points: &[Point2]) -> Vec<Change> {
    [-900, -30, 1, 30, 900]
        .into_iter()
        .filter_map(|exponent| {
            let (by, back) = (2.0_f64.powi(exponent), 2.0_f64.powi(-exponent));
            let name = format!("scaled by 2^{exponent}");
            let scale = |factor: f64| move |p: Point2| p.map(|x| x * factor);
            Change::moved(&name, points, Handedness::Kept, scale(by), scale(back))
        })
        .collect()
}

/// By whole numbers, where no sum is rounded.
fn translations(points: &[Point2]) -> Vec<Change> {
    [[1.0, -2.0], [-1024.0, 4096.0]]
        .into_iter()
        .filter_map(|[dx, dy]| {
            let exact = |x: f64, d: f64| sum_is_exact(x, d);
            if !points.iter().all(|&[x, y]| exact(x, dx) && exact(y, dy)) {
                return None;
            }
            let name = format!("moved by ({dx}, {dy})");
            let motion = |[x, y]: Point2| [x + dx, y + dy];
            let back = |[x, y]: Point2| [x - dx, y - dy];
            Change::moved(&name, points, Handedness::Kept, motion, back)
        })
        .collect()
}

/// Whether x + d is not rounded: both parts can be recovered from the sum (Knuth's two-sum has no error term).
fn sum_is_exact(x: f64, d: f64) -> bool {
    let sum = x + d;
    let d_in_sum = sum - x;
    let x_in_sum = sum - d_in_sum;
    d_in_sum == d && x_in_sum == x
}

fn ids(points: &[Point2]) -> std::ops::Range<u32> {
    0..points.len() as u32
}

/// A random order (Fisher and Yates).
pub(super) fn shuffle(ids: &mut [u32], seed: u64) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    for i in (1..ids.len()).rev() {
        ids.swap(i, rng.random_range(0..=i));
    }
}
