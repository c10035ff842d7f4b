//! The points that are still outside, numbered for the memory's sake.
//!
//! Points of one outside set are neighbours in space, but lie anywhere in the caller's slice, and each question about
//! one waits for memory. Now and then the points that are left are copied in the order of the sets. From then on a set is
//! a stretch of memory, and what becomes of it lies within.
//!
//! A point's number here is its *place*; copies of one point keep their order.

use geometry_core::{Point3, Points};
use std::borrow::Cow;

/// The points by place.
#[derive(Debug)]
pub(super) struct Sites<'a> {
    coordinates: Cow<'a, [Point3]>,
    ids: Vec<u32>,
}

impl<'a> Sites<'a> {
    /// All points, each at the place of its index.
    pub(super) fn of(points: Points<'a, 3>) -> Self {
        Self {
            coordinates: Cow::Borrowed(points.as_slice()),
            ids: points.ids().collect(),
        }
    }

    /// The coordinates by place.
    pub(super) fn coordinates(&self) -> &[Point3] {
        &self.coordinates
    }

    /// The caller's index of the point at a place.
    pub(super) fn id(&self, place: u32) -> u32 {
        self.ids[place as usize]
    }

    /// Keeps only the points at the places `order`, which get the places 0, 1, 2 …
    pub(super) fn reorder(&mut self, order: &[u32]) {
        let kept = order.iter().map(|&place| place as usize);
        let coordinates = kept.clone().map(|place| self.coordinates[place]).collect();
        self.ids = kept.map(|place| self.ids[place]).collect();
        self.coordinates = Cow::Owned(coordinates);
    }
}
