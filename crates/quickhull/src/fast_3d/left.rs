//! The points left when those that are certainly inside are discarded.

use geometry_core::Point3;

/// Some of the caller's points, in the caller's order, with their indices.
#[derive(Debug, Default)]
pub(super) struct Left {
    pub(super) points: Vec<Point3>,
    pub(super) ids: Vec<u32>,
}

impl Left {
    /// Parts one behind the other.
    pub(super) fn joined(parts: Vec<Self>) -> Self {
        let len = parts.iter().map(|part| part.ids.len()).sum();
        let mut all = Self {
            points: Vec::with_capacity(len),
            ids: Vec::with_capacity(len),
        };
        for part in parts {
            all.points.extend(part.points);
            all.ids.extend(part.ids);
        }
        all
    }

    /// One point in so many, spread evenly over the points but not at equal distances, as a lattice would not stand that.
    pub(super) fn sample_of(points: &[Point3], size: usize) -> Self {
        /// 2⁶⁴ divided by the golden ratio: its multiples are spread evenly over 0..2⁶⁴.
        const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
        let block = points.len() / size.max(1);
        let place = |number: usize| {
            let share = (number as u64 + 1).wrapping_mul(GOLDEN) >> 32;
            number * block + ((share * block as u64) >> 32) as usize
        };
        let ids: Vec<u32> = (0..size).map(|number| place(number) as u32).collect();
        Self {
            points: ids.iter().map(|&id| points[id as usize]).collect(),
            ids,
        }
    }

    /// [`sample_of`](Self::sample_of) these.
    pub(super) fn sample(&self, size: usize) -> Self {
        let mut sample = Self::sample_of(&self.points, size);
        for id in &mut sample.ids {
            *id = self.ids[*id as usize];
        }
        sample
    }
}
