//! What becomes of the points that are not vertices of a peel, chosen at compile time.

use geometry_core::{Observer, Step};

/// What a call of the routine does with the points that are not vertices.
pub(crate) trait Bookkeeping {
    /// Whether interior points are written back into LIST, for the next peel.
    const KEEPS_INTERIOR: bool;

    /// The point lies inside the peel.
    fn interior<O: Observer>(&mut self, id: u32, observer: &mut O);

    /// The point is a copy of a vertex with a smaller index.
    fn copy<O: Observer>(&mut self, id: u32, observer: &mut O);
}

/// One hull, with LIST left ready for a next peel, as the paper's routine leaves it.
pub(crate) struct Single;

impl Bookkeeping for Single {
    const KEEPS_INTERIOR: bool = true;
    #[inline(always)]
    fn interior<O: Observer>(&mut self, id: u32, observer: &mut O) {
        observer.step(|| Step::Discard(id));
    }
    #[inline(always)]
    fn copy<O: Observer>(&mut self, id: u32, observer: &mut O) {
        observer.step(|| Step::Discard(id));
    }
}

/// One hull and nothing else.
pub(crate) struct Bare;

impl Bookkeeping for Bare {
    const KEEPS_INTERIOR: bool = false;
    #[inline(always)]
    fn interior<O: Observer>(&mut self, id: u32, observer: &mut O) {
        observer.step(|| Step::Discard(id));
    }
    #[inline(always)]
    fn copy<O: Observer>(&mut self, id: u32, observer: &mut O) {
        observer.step(|| Step::Discard(id));
    }
}

/// One peel of many: copies leave together with their vertex.
pub(crate) struct Peeling<'a> {
    /// The number of the present peel, from 1.
    pub(crate) stage: u32,
    /// The stage at which each point was peeled, 0 for those that were not.
    pub(crate) stages: &'a mut [u32],
}

impl Bookkeeping for Peeling<'_> {
    const KEEPS_INTERIOR: bool = true;
    #[inline(always)]
    fn interior<O: Observer>(&mut self, _: u32, _: &mut O) {}
    fn copy<O: Observer>(&mut self, id: u32, observer: &mut O) {
        self.stages[id as usize] = self.stage;
        observer.step(|| Step::Discard(id));
    }
}
