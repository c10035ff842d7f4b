//! Kernels in space whose answers contradict each other, and a bound on how long a method may listen to them.

use crate::arithmetic::scale::{order3, shadow};
use crate::conformance::hostile::{Lie, mix};
use geometry_core::{Axis, Kernel3, Point3, Sign, Stage};
use std::cell::Cell;
use std::cmp::Ordering;

/// A kernel that answers at random, and gives the lexicographic order as it is.
#[derive(Clone, Debug)]
pub struct Hostile3 {
    lie: Lie,
    /// One answer in so many is zero.
    one_zero_in: u64,
    asked: Cell<u64>,
}

impl Hostile3 {
    /// One kernel of each kind: answers settled or not, zeros common or rare.
    pub fn all() -> [Self; 4] {
        let kernel = |lie, one_zero_in| Self {
            lie,
            one_zero_in,
            asked: Cell::new(0),
        };
        [
            kernel(Lie::Settled, 3),
            kernel(Lie::Settled, 50),
            kernel(Lie::Fickle, 3),
            kernel(Lie::Fickle, 50),
        ]
    }

    /// What it is, for a report.
    pub fn name(&self) -> &'static str {
        match (self.lie, self.one_zero_in) {
            (Lie::Settled, 3) => "tallied, settled lies, many zeros",
            (Lie::Settled, _) => "tallied, settled lies, few zeros",
            (Lie::Fickle, 3) => "tallied, fickle lies, many zeros",
            (Lie::Fickle, _) => "tallied, fickle lies, few zeros",
        }
    }

    /// A random answer to question number `kind` about `points`.
    fn answer(&self, kind: u64, points: &[Point3]) -> Ordering {
        let number = self.asked.get() + 1;
        self.asked.set(number);
        let hash = match self.lie {
            // The two zeros are equal once zero is added.
            Lie::Settled => points
                .as_flattened()
                .iter()
                .fold(kind, |state, &x| mix(state ^ (x + 0.0).to_bits())),
            Lie::Fickle => mix(number),
        };
        if hash % self.one_zero_in == 0 {
            Ordering::Equal
        } else if hash >> 63 == 0 {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }
}

impl Kernel3 for Hostile3 {
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        (Sign::from(self.answer(1, &[a, b, c, d])), Stage::Filter)
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        let [a, b, c] = plane;
        (self.answer(2, &[a, b, c, p, q]), Stage::Filter)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let kind = 3 + axis as u64;
        (Sign::from(self.answer(kind, &[a, b, c])), Stage::Filter)
    }

    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        order3(a, b)
    }
}

/// A kernel that computes in `f32`: right where the answer is clear, and wrong where points are nearly degenerate,
/// which is how contradictions come about in earnest.
#[derive(Clone, Copy, Debug)]
pub struct Rounded;

fn vector(from: Point3, to: Point3) -> [f32; 3] {
    [0, 1, 2].map(|i| to[i] as f32 - from[i] as f32)
}

/// The volume of u, v, w, rounded at every step.
fn volume(u: [f32; 3], v: [f32; 3], w: [f32; 3]) -> f32 {
    let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
    minor(1, 2) * w[0] + minor(2, 0) * w[1] + minor(0, 1) * w[2]
}

impl Kernel3 for Rounded {
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let volume = volume(vector(a, b), vector(a, c), vector(a, d));
        (Sign::of(f64::from(volume)), Stage::Filter)
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        let [a, b, c] = plane;
        let [over_p, over_q] = [p, q].map(|p| volume(vector(a, b), vector(a, c), vector(a, p)));
        let order = over_p.partial_cmp(&over_q).unwrap_or(Ordering::Equal);
        (order, Stage::Filter)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let [a, b, c] = [a, b, c].map(|p| shadow(axis, p).map(|x| x as f32));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        (Sign::of(f64::from(area)), Stage::Filter)
    }

    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        order3(a, b)
    }
}

/// Passes questions on until there were too many, then panics: a method that asks for ever is stopped, one that
/// loops without asking is not.
pub struct Budget3<'a> {
    inner: &'a dyn Kernel3,
    budget: u64,
    left: Cell<u64>,
}

impl<'a> Budget3<'a> {
    /// Allows 1000 (n + 10)² questions about `n` points: far more than any method here needs for true answers.
    pub fn new(inner: &'a dyn Kernel3, n: usize) -> Self {
        let budget = 1000 * (n as u64 + 10).pow(2);
        Self {
            inner,
            budget,
            left: Cell::new(budget),
        }
    }

    fn spend(&self) -> &'a dyn Kernel3 {
        let left = self.left.get();
        assert!(
            left > 0,
            "more than {} questions asked: with contradictory answers the method does not stop",
            self.budget
        );
        self.left.set(left - 1);
        self.inner
    }
}

impl Kernel3 for Budget3<'_> {
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        self.spend().orient3_staged(a, b, c, d)
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        self.spend().compare_height_staged(plane, p, q)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        self.spend().shadow_staged(axis, a, b, c)
    }

    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.spend().lexicographic3(a, b)
    }
}
