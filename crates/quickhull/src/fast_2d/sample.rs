//! Some points of a slice, from all over it, looked at where they are: no copy of them is kept.
//!
//! They come in runs of neighbours, as many points share a line of the cache. Where the order of points says where they
//! lie, a run tells little more than one point, so runs are short.

use geometry_core::Point2;

/// The length of a run.
const RUN: usize = 4;

/// So many points are gathered at a time: few enough for the stack.
const PART: usize = 128;

/// The longest part: indices of 16 bits tell its points apart.
pub(super) const LONGEST_PART: usize = 1 << 16;

/// The first [`RUN`] of every `step` points, or all points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<'a> {
    points: &'a [Point2],
    step: usize,
}

impl<'a> Sample<'a> {
    pub(super) fn all(points: &'a [Point2]) -> Self {
        Self { points, step: RUN }
    }

    /// [`fewer`](Self::fewer) of all points.
    pub(super) fn some(points: &'a [Point2], count: usize) -> Self {
        Self::all(points).fewer(count)
    }

    /// Between half of `count` and `count` of these, but for a run; all if there are no more.
    pub(super) fn fewer(self, count: usize) -> Self {
        let share = self.len().div_ceil(count);
        if share <= 1 {
            return self;
        }
        // An odd step: in a lattice, row by row, runs begin in every column.
        let step = (self.step * share) | 1;
        Self { step, ..self }
    }

    pub(super) fn is_all(&self) -> bool {
        self.step == RUN
    }

    pub(super) fn first(&self) -> Option<Point2> {
        self.points.first().copied()
    }

    pub(super) fn len(&self) -> usize {
        let (whole, rest) = (self.points.len() / self.step, self.points.len() % self.step);
        whole * RUN + rest.min(RUN)
    }

    /// Hands out the points in their order, in parts of at most [`LONGEST_PART`].
    #[inline(always)]
    pub(super) fn in_parts(&self, mut take: impl FnMut(&[Point2])) {
        if self.is_all() {
            return self.points.chunks(LONGEST_PART).for_each(take);
        }
        let mut part = [[0.0; 2]; PART];
        for points in self.points.chunks(self.step * (PART / RUN)) {
            let mut len = 0;
            for (run, points) in part
                .as_chunks_mut::<RUN>()
                .0
                .iter_mut()
                .zip(points.chunks(self.step))
            {
                match points.first_chunk() {
                    Some(whole) => *run = *whole,
                    None => run[..points.len()].copy_from_slice(points),
                }
                len += points.len().min(RUN);
            }
            take(&part[..len]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn listed(sample: Sample<'_>) -> Vec<Point2> {
        let mut points = Vec::new();
        sample.in_parts(|part| points.extend_from_slice(part));
        points
    }

    #[test]
    fn a_sample_is_of_the_size_asked_for_and_in_order() {
        let points: Vec<Point2> = (0..200_000).map(|i| [f64::from(i), 0.0]).collect();
        for len in (0..70).chain([1_000, 4_095, 65_537, 200_000]) {
            let all = Sample::all(&points[..len]);
            assert_eq!(listed(all), points[..len]);
            for count in [1, 60, 256, 1_024, 16_384] {
                let some = all.fewer(count);
                let listed = listed(some);
                assert_eq!(listed.len(), some.len(), "{count} of {len}");
                assert!(listed.len() <= (count + RUN).min(len), "{count} of {len}");
                assert!(
                    2 * (listed.len() + RUN) >= count.min(len),
                    "{count} of {len}"
                );
                assert!(listed.is_sorted_by(|a, b| a[0] < b[0]));
                assert_eq!(listed.first(), points[..len].first());
                assert_eq!(some.is_all(), len <= count);
            }
        }
    }

    #[test]
    fn runs_begin_in_every_column_of_a_lattice() {
        let points: Vec<Point2> = (0..1_000_000_u32)
            .map(|i| [f64::from(i % 1000), 0.0])
            .collect();
        let mut seen = [false; 1000];
        for point in listed(Sample::some(&points, 1 << 14)) {
            seen[point[0] as usize] = true;
        }
        assert!(seen.iter().all(|&seen| seen));
    }
}
