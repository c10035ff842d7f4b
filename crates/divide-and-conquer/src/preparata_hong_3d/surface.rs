//! The working state of the method, and one merge as its four phases.

use super::edges::{Dart, Edges, Half, NONE};
use super::questions::Questions;
use super::shadow::Line;
use geometry_core::{HullError, Observer, Point3, Step};
use std::marker::PhantomData;
use std::ops::Range;

/// How the edges round a vertex are searched for the next facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scan {
    /// From where the last search at this vertex stopped, to the first edge that is no better.
    Resumed,
    /// All of them, at every step.
    Whole,
    /// Sorted by angle, all of them, at every step.
    Sorted,
}

/// A variant of the merge, chosen at compile time.
pub(crate) trait Policy {
    /// How edges are searched.
    const SCAN: Scan;
    /// Whether the hull of the shadow is kept from merge to merge, or scanned anew in each.
    const KEEPS_SHADOW: bool;
}

/// Why a merge could not be finished. Impossible with an exact kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// A walk went on for longer than any right one can.
    Endless,
    /// The facets of the wrap do not fit the hulls it joins.
    Tangled,
}

impl From<Fault> for HullError {
    fn from(fault: Fault) -> Self {
        HullError::Contradiction {
            what: match fault {
                Fault::Endless => "the wrap round two hulls does not come back to its start",
                Fault::Tangled => "the wrap round two hulls does not fit them",
            },
        }
    }
}

/// What happened in one merge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MergeRecord {
    /// The points in the two halves together.
    pub points: u32,
    /// The vertices of the two hulls together.
    pub vertices_before: u32,
    /// The vertices of the merged hull.
    pub vertices_after: u32,
    /// The comparisons of two candidate edges, by one orientation of four points each.
    pub candidates: u64,
    /// The candidates looked at again after a search had passed them. (Of a resumed search, passed since the wrap moved
    /// on for the first time in that half: it begins amid a visit to a vertex, and ends with the visit's first part.)
    pub reexamined: u64,
    /// The facets of the wrap.
    pub facets: u32,
    /// The edge records made (or made use of again).
    pub edges_made: u32,
    /// The edge records freed.
    pub edges_freed: u32,
    /// The edge records in use after the merge, in all hulls of this arena.
    pub edges_live: u32,
}

/// What is known of a place in the sorted order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// An edge away from it; [`NONE`] if it has none, because it is alone or no vertex any more.
    pub(super) spoke: u32,
    /// The place before it on the ring of the shadow, if it is on one.
    pub(super) before: u32,
    /// The place after it, anticlockwise.
    pub(super) after: u32,
    /// The last merge whose wrap touched it.
    pub(super) wrapped_by: u32,
}

impl Place {
    pub(super) fn has_edges(&self) -> bool {
        self.spoke != NONE
    }
}

/// One facet of a wrap: the edge of a half that it stands on, directed as the wrap runs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) half: Half,
    pub(super) dart: Dart,
}

/// The hulls of disjoint ranges of the sorted order.
pub(crate) struct Surface<'a, P, Q, O> {
    /// The points by place.
    pub(super) points: &'a [Point3],
    /// The caller's indices by place.
    pub(super) ids: &'a [u32],
    pub(super) questions: &'a Q,
    pub(super) observer: O,
    pub(super) places: Vec<Place>,
    pub(super) edges: Edges,
    /// The number of the current merge.
    pub(super) merge: u32,
    pub(super) record: MergeRecord,
    /// The facets of the current wrap.
    pub(super) turns: Vec<Turn>,
    /// Whether one of them stands on the same edge as another, which is never right.
    pub(super) repeats: bool,
    /// The edges hidden by the current wrap, each once.
    pub(super) hidden: Vec<Dart>,
    policy: PhantomData<P>,
}

impl<'a, P: Policy, Q: Questions, O: Observer> Surface<'a, P, Q, O> {
    /// Every point its own hull.
    pub(crate) fn new(points: &'a [Point3], ids: &'a [u32], questions: &'a Q, observer: O) -> Self {
        let alone = |place: u32| Place {
            spoke: NONE,
            before: place,
            after: place,
            wrapped_by: NONE,
        };
        Self {
            points,
            ids,
            questions,
            observer,
            places: (0..points.len() as u32).map(alone).collect(),
            edges: Edges::with_capacity(points.len()),
            merge: 0,
            record: MergeRecord::default(),
            turns: Vec::new(),
            repeats: false,
            hidden: Vec::new(),
            policy: PhantomData,
        }
    }

    #[inline(always)]
    pub(super) fn point(&self, place: u32) -> Point3 {
        self.points[place as usize]
    }

    pub(super) fn id(&self, place: u32) -> u32 {
        self.ids[place as usize]
    }

    /// The hull of `range`, by halves; `log` hears of each merge. Returns its number of vertices.
    pub(crate) fn conquer(
        &mut self,
        range: Range<usize>,
        log: &mut impl FnMut(MergeRecord),
    ) -> Result<u32, Fault> {
        if range.len() < 2 {
            return Ok(range.len() as u32);
        }
        let middle = range.start + range.len() / 2;
        let first = self.conquer(range.start..middle, log)?;
        let second = self.conquer(middle..range.end, log)?;
        let vertices = self.merge(range, middle, first + second)?;
        log(self.record);
        Ok(vertices)
    }

    /// Joins the hulls of the halves of `range`, which have `vertices` vertices together.
    pub(crate) fn merge(
        &mut self,
        range: Range<usize>,
        middle: usize,
        vertices: u32,
    ) -> Result<u32, Fault> {
        self.merge += 1;
        self.record = MergeRecord {
            points: range.len() as u32,
            vertices_before: vertices,
            ..MergeRecord::default()
        };
        if !P::KEEPS_SHADOW {
            self.scan_ring(range.start..middle);
            self.scan_ring(middle..range.end);
        }
        let lower = self.supporting_line(Line::Lower, &range, middle)?;
        let upper = self.supporting_line(Line::Upper, &range, middle)?;
        let alone = [middle - range.start, range.end - middle].map(|count| count == 1);
        for (place, alone) in upper.into_iter().zip(alone) {
            // Hidden vertices have left the ring.
            if !alone && !self.places[place as usize].has_edges() {
                return Err(Fault::Tangled);
            }
        }
        // A flat facet is triangulated as a fan from its lowest corner, which the lower line often meets: at the upper
        // line the first search has fewer edges to look at.
        self.wrap(upper, range.len())?;
        let vertices = vertices
            .checked_sub(self.hide(upper)?)
            .ok_or(Fault::Tangled)?;
        self.sew(upper);
        self.join_rings(lower, upper);
        self.report(vertices);
        Ok(vertices)
    }

    fn report(&mut self, vertices: u32) {
        self.record.vertices_after = vertices;
        self.record.edges_live = self.edges.live() as u32;
        let MergeRecord {
            vertices_before,
            edges_live,
            ..
        } = self.record;
        self.observer.step(|| Step::Storage(edges_live));
        self.observer.step(|| Step::Merge(vertices_before));
    }

    /// Takes in the hulls of the points that follow, to be merged with those here.
    ///
    /// `points` and `ids` are those of both.
    pub(crate) fn absorb<R: Observer>(
        &mut self,
        other: &Surface<'_, P, Q, R>,
        points: &'a [Point3],
        ids: &'a [u32],
    ) {
        let shift = self.places.len() as u32;
        let dart_shift = self.edges.absorb(&other.edges, shift);
        self.places.extend(other.places.iter().map(|place| Place {
            spoke: if place.has_edges() {
                place.spoke + dart_shift
            } else {
                NONE
            },
            before: place.before + shift,
            after: place.after + shift,
            wrapped_by: NONE,
        }));
        (self.points, self.ids) = (points, ids);
    }
}
