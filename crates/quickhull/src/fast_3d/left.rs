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

    /// These, and the others behind them.
    pub(super) fn and(&self, others: &Self) -> Self {
        Self {
            points: [&*self.points, &others.points].concat(),
            ids: [&*self.ids, &others.ids].concat(),
        }
    }

    /// Those at these places.
    pub(super) fn picked(&self, places: &[u32]) -> Self {
        let places = || places.iter().map(|&place| place as usize);
        Self {
            points: places().map(|place| self.points[place]).collect(),
            ids: places().map(|place| self.ids[place]).collect(),
        }
    }

    /// One point in so many, at the [places of a sample](Self::places_of_sample).
    pub(super) fn sample_of(points: &[Point3], size: usize) -> Self {
        let ids = Self::places_of_sample(points.len(), size);
        Self {
            points: ids.iter().map(|&id| points[id as usize]).collect(),
            ids,
        }
    }

    /// Places spread evenly over `count` points but not at equal distances, as a lattice would not stand that.
    pub(super) fn places_of_sample(count: usize, size: usize) -> Vec<u32> {
        /// 2⁶⁴ divided by the golden ratio: its multiples are spread evenly over 0..2⁶⁴.
        const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
        let block = count / size.max(1);
        let place = |number: usize| {
            let share = (number as u64 + 1).wrapping_mul(GOLDEN) >> 32;
            number * block + ((share * block as u64) >> 32) as usize
        };
        (0..size).map(|number| place(number) as u32).collect()
    }

    /// Some of these, numbered by their places among them, with their indices.
    pub(super) fn those_of(&self, mut some: Self) -> Self {
        for id in &mut some.ids {
            *id = self.ids[*id as usize];
        }
        some
    }

    /// [`sample_of`](Self::sample_of) these.
    pub(super) fn sample(&self, size: usize) -> Self {
        self.those_of(Self::sample_of(&self.points, size))
    }
}
