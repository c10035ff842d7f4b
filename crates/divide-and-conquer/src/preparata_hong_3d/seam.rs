//! What a wrap does to the two hulls: edges inside the merged hull are freed, and the bridges are sewn in.
//!
//! At each visit of the wrap to a vertex, it arrives along one edge of the half and leaves along another. The edges
//! between them, in the direction of the scan, are hidden, and the bridges made meanwhile take their place. The sectors
//! of different visits to one vertex are disjoint, because surviving facets lie between them.

use super::edges::{Dart, Edges, Half, Note};
use super::questions::Questions;
use super::surface::{Fault, Policy, Surface};
use geometry_core::{Observer, Step};

impl<P: Policy, Q: Questions, O: Observer> Surface<'_, P, Q, O> {
    /// Frees all edges hidden by the wrap that began at `start`. Returns how many vertices are hidden.
    ///
    /// Checks that the wrap fits, so that whatever the answers were the links stay sound: no edge is taken twice in
    /// one direction, no taken edge is hidden, and an edge hidden at one end is so at the other.
    pub(super) fn hide(&mut self, start: [u32; 2]) -> Result<u32, Fault> {
        self.hidden.clear();
        if self.repeats {
            return Err(Fault::Tangled);
        }
        for half in Half::BOTH {
            self.hide_sectors(half, start[half as usize])?;
        }
        let vertices = self.hide_beyond()?;
        if O::ACTIVE {
            self.report_dropped();
        }
        self.record.edges_freed = self.hidden.len() as u32;
        for &dart in &self.hidden {
            self.edges.free(dart);
        }
        Ok(vertices)
    }

    /// Hides the sectors at the vertices of one half that the wrap went through.
    fn hide_sectors(&mut self, half: Half, start: u32) -> Result<(), Fault> {
        let mut own = self.turns.iter().filter(|turn| turn.half == half);
        let Some(last) = own.next_back() else {
            // The wrap went all round one vertex.
            let place = &self.places[start as usize];
            if place.has_edges() {
                let spoke = Dart(place.spoke);
                self.edges.hide(self.merge, spoke, &mut self.hidden)?;
                let next = self.edges.onward(half, spoke);
                self.edges
                    .hide_sector(self.merge, half, next, spoke, &mut self.hidden)?;
            }
            return Ok(());
        };
        let mut arrival = last.dart.reversed();
        for turn in own.chain([last]) {
            let next = self.edges.onward(half, arrival);
            self.edges
                .hide_sector(self.merge, half, next, turn.dart, &mut self.hidden)?;
            arrival = turn.dart.reversed();
        }
        Ok(())
    }

    /// Hides everything that hangs on hidden edges away from the wrap. Returns the number of vertices there.
    fn hide_beyond(&mut self) -> Result<u32, Fault> {
        let (mut vertices, mut reached) = (0, 0);
        while let Some(&dart) = self.hidden.get(reached) {
            reached += 1;
            let far = dart.reversed();
            if self.edges.is_noted(self.merge, far, Note::Hidden) {
                continue;
            }
            let place = &mut self.places[self.edges.origin(far) as usize];
            if place.wrapped_by == self.merge {
                return Err(Fault::Tangled);
            }
            place.spoke = super::edges::NONE;
            vertices += 1;
            self.edges.hide(self.merge, far, &mut self.hidden)?;
            let next = self.edges.onward(Half::First, far);
            self.edges
                .hide_sector(self.merge, Half::First, next, far, &mut self.hidden)?;
        }
        Ok(vertices)
    }

    /// Tells the observer of every facet that the wrap hid, once.
    fn report_dropped(&mut self) {
        let taken = self.turns.iter().map(|turn| turn.half.end_of(turn.dart));
        let hidden = self.hidden.iter().flat_map(|&dart| [dart, dart.reversed()]);
        for dart in taken.chain(hidden) {
            if let Some(facet) = self.edges.triangle(dart)
                && facet.iter().all(|&other| dart <= other)
            {
                let [a, b, c] = facet.map(|dart| self.ids[self.edges.origin(dart) as usize]);
                self.observer.step(|| Step::Drop(a, b, c));
            }
        }
    }

    /// Makes the bridges and links them in, replaying the wrap.
    pub(super) fn sew(&mut self, start: [u32; 2]) {
        let first = self.edges.make(start[0], start[1]);
        self.set_spokes(first);
        let mut latest = Half::BOTH.map(|half| half.end_of(first));
        let mut ends = start;
        for (i, turn) in self.turns.iter().enumerate() {
            let moved = turn.half as usize;
            self.edges.link(turn.half, latest[moved], turn.dart);
            latest[moved] = turn.dart.reversed();
            ends[moved] = self.edges.target(turn.dart);
            let is_last = i + 1 == self.turns.len();
            let bridge = if is_last {
                first
            } else {
                self.edges.make(ends[0], ends[1])
            };
            for half in Half::BOTH {
                let end = half.end_of(bridge);
                self.edges.link(half, latest[half as usize], end);
                latest[half as usize] = end;
                self.places[ends[half as usize] as usize].spoke = end.0;
            }
        }
        self.record.facets = self.turns.len() as u32;
        self.record.edges_made = self.record.facets.max(1);
    }

    fn set_spokes(&mut self, bridge: Dart) {
        for half in Half::BOTH {
            let end = half.end_of(bridge);
            self.places[self.edges.origin(end) as usize].spoke = end.0;
        }
    }
}

impl Edges {
    /// Hides the darts from `next` up to but not including `until`, in the direction of the scan.
    fn hide_sector(
        &mut self,
        merge: u32,
        half: Half,
        mut next: Dart,
        until: Dart,
        hidden: &mut Vec<Dart>,
    ) -> Result<(), Fault> {
        while next != until {
            self.hide(merge, next, hidden)?;
            next = self.onward(half, next);
        }
        Ok(())
    }

    /// Hides one dart, and lists its edge unless the other end is hidden already.
    fn hide(&mut self, merge: u32, dart: Dart, hidden: &mut Vec<Dart>) -> Result<(), Fault> {
        let is = |dart: Dart, note: Note| self.is_noted(merge, dart, note);
        if is(dart, Note::Taken) || is(dart.reversed(), Note::Taken) || is(dart, Note::Hidden) {
            return Err(Fault::Tangled);
        }
        if !is(dart.reversed(), Note::Hidden) {
            hidden.push(dart);
        }
        self.note(merge, dart, Note::Hidden);
        Ok(())
    }
}
