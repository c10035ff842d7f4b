//! The points left when those that are certainly inside are discarded.

use super::core::{BLOCK, all_places};
use super::directions::DirectionMap;
use geometry_core::{Observer, Point3, Points, Step};

/// Some of the caller's points, in the caller's order, with their indices.
#[derive(Debug, Default)]
pub(super) struct Left {
    pub(super) points: Vec<Point3>,
    pub(super) ids: Vec<u32>,
}

impl Left {
    /// The points, numbered from `first`, that the map does not find inside.
    pub(super) fn of<O: Observer>(
        points: &[Point3],
        first: u32,
        map: &DirectionMap,
        observer: &mut O,
    ) -> Self {
        let mut left = Self::default();
        let mut places = [0; BLOCK];
        for (number, block) in points.chunks(BLOCK).enumerate() {
            let start = first + (number * BLOCK) as u32;
            let kept = match &map.core {
                Some(core) => core.outside(block, &mut places),
                None => {
                    places = all_places();
                    block.len()
                }
            };
            let kept = map.keep_outside(block, &mut places, kept);
            let outside = &places[..kept];
            let points = outside.iter().map(|&place| block[usize::from(place)]);
            left.points.extend(points);
            left.ids
                .extend(outside.iter().map(|&place| start + u32::from(place)));
            left.tell(start, block.len(), observer);
        }
        left
    }

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

    /// One visit for each point of a block, and a discard for those that are not among the last ones left.
    fn tell<O: Observer>(&self, start: u32, len: usize, observer: &mut O) {
        if !O::ACTIVE {
            return;
        }
        let before = self.ids.partition_point(|&id| id < start);
        let mut kept = self.ids[before..].iter().copied().peekable();
        for id in start..start + len as u32 {
            observer.step(|| Step::Visit(id));
            if kept.next_if_eq(&id).is_none() {
                observer.step(|| Step::Discard(id));
            }
        }
    }

    /// One point in so many, spread evenly over the points but not at equal distances, as a lattice would not stand that.
    pub(super) fn sample(points: Points<'_, 3>, size: usize) -> Self {
        /// 2⁶⁴ divided by the golden ratio: its multiples are spread evenly over 0..2⁶⁴.
        const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;
        let block = points.len() / size.max(1);
        let place = |number: usize| {
            let share = (number as u64 + 1).wrapping_mul(GOLDEN) >> 32;
            number * block + ((share * block as u64) >> 32) as usize
        };
        let ids: Vec<u32> = (0..size).map(|number| place(number) as u32).collect();
        Self {
            points: ids.iter().map(|&id| points[id]).collect(),
            ids,
        }
    }
}
