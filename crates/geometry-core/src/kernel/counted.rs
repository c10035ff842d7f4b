//! A kernel that counts the questions it is asked.

use super::space::{Axis, Basis, Kernel3};
use super::{InCircle, Kernel2, Stage};
use crate::points::{Point2, Point3};
use crate::sign::Sign;
use std::cell::Cell;
use std::cmp::Ordering;
use std::ops::AddAssign;

/// How many questions of one kind were settled at each stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageCounts {
    /// Settled by the first evaluation.
    pub filter: u64,
    /// Settled by adaptive arithmetic.
    pub adaptive: u64,
    /// Settled by scaled integers.
    pub integer: u64,
}

impl StageCounts {
    /// All questions of this kind.
    pub fn total(&self) -> u64 {
        self.filter + self.adaptive + self.integer
    }

    fn add(&mut self, stage: Stage) {
        match stage {
            Stage::Filter => self.filter += 1,
            Stage::Adaptive => self.adaptive += 1,
            Stage::Integer => self.integer += 1,
        }
    }
}

impl AddAssign for StageCounts {
    fn add_assign(&mut self, other: Self) {
        self.filter += other.filter;
        self.adaptive += other.adaptive;
        self.integer += other.integer;
    }
}

/// How many questions of each kind were asked. Exact integers, equal on every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct QuestionCounts {
    /// Orientations of three points of the plane: the area evaluations of Green and Silverman.
    pub orientations: StageCounts,
    /// Comparisons of two distances from a line.
    pub distances: StageCounts,
    /// Comparisons along a line.
    pub along: u64,
    /// Lexicographic comparisons.
    pub lexicographic: u64,
    /// Comparisons of two polar angles about a centre (the orientation inside one is not counted again).
    pub angles: u64,
    /// In-circle questions.
    pub in_circles: StageCounts,
    /// Orientations of four points of space.
    pub orientations_in_space: StageCounts,
    /// Comparisons of two heights over a plane.
    pub heights: StageCounts,
    /// Orientations of shadows.
    pub shadows: StageCounts,
}

impl QuestionCounts {
    /// All questions of every kind.
    pub fn total(&self) -> u64 {
        self.orientations.total()
            + self.distances.total()
            + self.along
            + self.lexicographic
            + self.angles
            + self.in_circles.total()
            + self.orientations_in_space.total()
            + self.heights.total()
            + self.shadows.total()
    }
}

impl AddAssign for QuestionCounts {
    fn add_assign(&mut self, other: Self) {
        self.orientations += other.orientations;
        self.distances += other.distances;
        self.along += other.along;
        self.lexicographic += other.lexicographic;
        self.angles += other.angles;
        self.in_circles += other.in_circles;
        self.orientations_in_space += other.orientations_in_space;
        self.heights += other.heights;
        self.shadows += other.shadows;
    }
}

/// Passes every question on to `K` and counts it.
///
/// ```
/// use geometry_core::{Counted, Exact, Kernel2};
/// let kernel = Counted::new(Exact);
/// kernel.orient([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]);
/// kernel.orient([0.1, 0.1], [0.2, 0.2], [0.3, 0.3]);
/// let orientations = kernel.counts().orientations;
/// assert_eq!(orientations.total(), 2);
/// assert_eq!(orientations.filter, 1); // the second one, nearly collinear, had to be looked at closely
/// ```
#[derive(Debug, Default)]
pub struct Counted<K> {
    inner: K,
    counts: Cell<QuestionCounts>,
}

impl<K> Counted<K> {
    /// Starts counting the questions asked of `inner`.
    pub fn new(inner: K) -> Self {
        Self {
            inner,
            counts: Cell::default(),
        }
    }

    /// What has been asked so far.
    pub fn counts(&self) -> QuestionCounts {
        self.counts.get()
    }

    fn count(&self, add: impl FnOnce(&mut QuestionCounts)) {
        let mut counts = self.counts.get();
        add(&mut counts);
        self.counts.set(counts);
    }
}

impl<K: Kernel2> Kernel2 for Counted<K> {
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        let answer = self.inner.orient_staged(a, b, c);
        self.count(|n| n.orientations.add(answer.1));
        answer
    }

    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        let answer = self.inner.compare_distance_staged(a, b, p, q);
        self.count(|n| n.distances.add(answer.1));
        answer
    }

    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        self.count(|n| n.along += 1);
        self.inner.compare_along(a, b, p, q)
    }

    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        self.count(|n| n.lexicographic += 1);
        self.inner.lexicographic(a, b)
    }

    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        self.count(|n| n.angles += 1);
        self.inner.compare_angle(center, a, b)
    }
}

impl<K: InCircle> InCircle for Counted<K> {
    fn in_circle_staged(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
        let answer = self.inner.in_circle_staged(a, b, c, d);
        self.count(|n| n.in_circles.add(answer.1));
        answer
    }
}

impl<K: Kernel3> Kernel3 for Counted<K> {
    fn basis(&self) -> Basis {
        self.inner.basis()
    }

    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let answer = self.inner.orient3_staged(a, b, c, d);
        self.count(|n| n.orientations_in_space.add(answer.1));
        answer
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        let answer = self.inner.compare_height_staged(plane, p, q);
        self.count(|n| n.heights.add(answer.1));
        answer
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let answer = self.inner.shadow_staged(axis, a, b, c);
        self.count(|n| n.shadows.add(answer.1));
        answer
    }

    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.count(|n| n.lexicographic += 1);
        self.inner.lexicographic3(a, b)
    }
}
