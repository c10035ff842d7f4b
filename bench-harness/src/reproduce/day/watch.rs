//! A kernel that counts all questions, and those of which the answer is that something vanishes; it may be asked by several
//! threads at once.

use geometry_core::{Axis, Kernel3, Point3, Sign, Stage};
use std::cmp::Ordering;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Passes every question on to `K`.
#[derive(Debug, Default)]
pub(crate) struct Watched<K> {
    inner: K,
    questions: AtomicU64,
    vanished: AtomicU64,
}

impl<K> Watched<K> {
    pub(crate) fn new(inner: K) -> Self {
        Self {
            inner,
            questions: AtomicU64::new(0),
            vanished: AtomicU64::new(0),
        }
    }

    /// Questions of every kind.
    pub(crate) fn questions(&self) -> u64 {
        self.questions.load(Relaxed)
    }

    /// Orientations, of four points or of three shadows, that were zero: what a perturbation must settle.
    pub(crate) fn vanished(&self) -> u64 {
        self.vanished.load(Relaxed)
    }

    fn count(&self, vanishes: bool) {
        self.questions.fetch_add(1, Relaxed);
        self.vanished.fetch_add(u64::from(vanishes), Relaxed);
    }
}

impl<K: Kernel3> Kernel3 for Watched<K> {
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let answer = self.inner.orient3_staged(a, b, c, d);
        self.count(answer.0.is_zero());
        answer
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        self.count(false);
        self.inner.compare_height_staged(plane, p, q)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let answer = self.inner.shadow_staged(axis, a, b, c);
        self.count(answer.0.is_zero());
        answer
    }

    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.count(false);
        self.inner.lexicographic3(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::Exact;

    #[test]
    fn what_vanishes_is_counted_apart() {
        let kernel = Watched::new(Exact);
        let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        kernel.orient3(a, b, c, d);
        kernel.orient3(a, b, c, [1.0, 1.0, 0.0]);
        kernel.shadow(Axis::Z, a, b, [2.0, 0.0, 1.0]);
        kernel.lexicographic3(a, b);
        assert_eq!((kernel.questions(), kernel.vanished()), (4, 2));
    }
}
