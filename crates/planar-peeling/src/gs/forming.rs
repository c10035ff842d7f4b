//! A test list while it is formed.

use super::call::Draft;
use geometry_core::{Boundary, Kernel2, Point2, Points};
use std::cmp::Ordering;

/// The test list of the line from→to while points are put into it.
pub(super) struct Forming {
    from: Point2,
    to: Point2,
    /// Index, coordinates and cell of the furthest point so far.
    furthest: Option<(u32, Point2, usize)>,
    /// How many of the points are on the line, not outside.
    doubtful: usize,
}

impl Forming {
    pub(super) fn new(from: Point2, to: Point2) -> Self {
        Self {
            from,
            to,
            furthest: None,
            doubtful: 0,
        }
    }

    /// Whether `point` belongs into the list, being outside or a doubtful point: one orientation. `None` for a copy
    /// of an end of the line. Doubtful points are counted.
    #[inline(always)]
    pub(super) fn lists<K: Kernel2>(
        &mut self,
        kernel: &K,
        boundary: Boundary,
        point: Point2,
    ) -> Option<bool> {
        let sign = kernel.orient(self.from, self.to, point);
        if sign.is_zero() {
            return self.lists_on_line(kernel, boundary, point);
        }
        Some(sign.is_negative())
    }

    #[cold]
    fn lists_on_line<K: Kernel2>(
        &mut self,
        kernel: &K,
        boundary: Boundary,
        point: Point2,
    ) -> Option<bool> {
        if self.ends_in_copy_of(kernel, point) {
            return None;
        }
        let before = |p, q| kernel.compare_along(self.from, self.to, p, q).is_lt();
        let between = before(self.from, point) && before(point, self.to);
        let doubtful = boundary == Boundary::All && between;
        self.doubtful += usize::from(doubtful);
        Some(doubtful)
    }

    pub(super) fn ends_in_copy_of<K: Kernel2>(&self, kernel: &K, point: Point2) -> bool {
        [self.from, self.to]
            .iter()
            .any(|&end| kernel.lexicographic(end, point).is_eq())
    }

    /// Notes the furthest of the points `ids` just listed, which are in the cells from `first` on.
    ///
    /// Of points equally far, the one nearest to the end of the line is an extreme point (invariant 3); of
    /// copies, the smallest index stands for all.
    #[inline]
    pub(super) fn note<K: Kernel2>(
        &mut self,
        kernel: &K,
        points: Points<'_, 2>,
        ids: &[u32],
        first: usize,
    ) {
        let &[head, ..] = ids else {
            return;
        };
        let (mut best, mut furthest, mut cell) =
            self.furthest.unwrap_or((head, points[head], first));
        let fresh = usize::from(self.furthest.is_none());
        for (offset, &id) in ids.iter().enumerate().skip(fresh) {
            let point = points[id];
            // Further to the right of from→to is further to the left of to→from.
            let further =
                match kernel.compare_distance_then_along(self.to, self.from, point, furthest) {
                    Ordering::Greater => true,
                    Ordering::Equal => id < best,
                    Ordering::Less => false,
                };
            if further {
                (best, furthest, cell) = (id, point, first + offset);
            }
        }
        self.furthest = Some((best, furthest, cell));
    }

    /// The list as it will be in NWK, at `at` and of `len` points. It has no furthest point if all are doubtful.
    pub(super) fn draft(&self, at: usize, len: usize) -> Draft {
        let furthest = match self.furthest {
            Some((.., cell)) if self.doubtful < len => Some(cell),
            _ => None,
        };
        Draft { at, len, furthest }
    }
}
