//! Steps told in the caller's indices, when the points at work are only some of the caller's.

use geometry_core::{Observer, Step};

/// Passes steps about the points 0, 1, 2 … on as steps about `ids[0]`, `ids[1]`, `ids[2]` …, or as they are.
pub(super) struct Renumbered<'a, O> {
    pub(super) observer: &'a mut O,
    pub(super) ids: Option<&'a [u32]>,
}

impl<O: Observer> Observer for Renumbered<'_, O> {
    const ACTIVE: bool = O::ACTIVE;

    fn record(&mut self, step: Step) {
        let id = |place: u32| self.ids.map_or(place, |ids| ids[place as usize]);
        // The steps that a surface takes.
        self.observer.record(match step {
            Step::Visit(p) => Step::Visit(id(p)),
            Step::Apex(p) => Step::Apex(id(p)),
            Step::Insert(p) => Step::Insert(id(p)),
            Step::Discard(p) => Step::Discard(id(p)),
            Step::Facet(a, b, c) => Step::Facet(id(a), id(b), id(c)),
            Step::Drop(a, b, c) => Step::Drop(id(a), id(b), id(c)),
            other => other,
        });
    }
}
