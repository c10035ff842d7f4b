//! The shape of a surface: steps 3 to 6 of the argument ([`super`]).

use super::finding3::{Finding3, verdict};
use super::surface::Surface;
use crate::arithmetic::scale::{Scale, Side, order3, shadow};
use crate::arithmetic::{Turn, order};
use geometry_core::{Axis, Point3};

/// A surface with its coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape<'a> {
    pub(super) points: &'a [Point3],
    pub(super) scale: Scale,
    pub(super) surface: &'a Surface,
}

/// Whether each facet is seen from above (`Left`), from below (`Right`), or not at all (`Straight`).
pub(super) type Facing = Vec<Turn>;

impl Shape<'_> {
    /// Steps 3 to 6, or the findings of the first that fails. O(m log m) for m sides.
    pub(super) fn facing_if_convex(&self) -> Result<Facing, Vec<Finding3>> {
        let mut findings = Vec::new();
        for facet in 0..self.surface.facet_count() as u32 {
            findings.extend(self.facet_fault(facet));
        }
        verdict(findings)?;
        verdict(self.edge_faults())?;
        let facing: Facing = (0..self.surface.facet_count() as u32)
            .map(|facet| {
                let [a, b, c] = self.plane(self.surface.first_side(facet));
                self.scale.turn(Axis::Z, a, b, c)
            })
            .collect();
        self.outline_goes_round_once(&facing)?;
        Ok(facing)
    }

    pub(super) fn at(&self, id: u32) -> Point3 {
        self.points[id as usize]
    }

    /// Three points that span the plane of the facet of `side`, in its order: both ends, and the corner after.
    pub(super) fn plane(&self, side: u32) -> [Point3; 3] {
        let next = self.surface.next(side);
        [side, next, self.surface.next(next)].map(|side| self.at(self.surface.origin(side)))
    }

    /// Step 3.
    fn facet_fault(&self, facet: u32) -> Option<Finding3> {
        let corners = self.surface.corners(facet);
        let [a, b, c] = [0, 1, 2].map(|i| self.at(corners[i]));
        let axes = [Axis::Z, Axis::X, Axis::Y];
        let turns = axes.map(|axis| (axis, self.scale.turn(axis, a, b, c)));
        let Some((axis, anticlockwise)) =
            turns.into_iter().find(|&(_, turn)| turn != Turn::Straight)
        else {
            return Some(Finding3::FlatFacet { facet });
        };
        if corners.len() == 3 {
            return None;
        }
        for &corner in &corners[3..] {
            if self.scale.side(a, b, c, self.at(corner)) != Side::On {
                return Some(Finding3::OffPlane { facet, corner });
            }
        }
        let mut revolutions = 0;
        for [before, at, after] in triples(corners) {
            let [p, q, r] = [before, at, after].map(|id| self.at(id));
            match self.scale.turn(axis, p, q, r) {
                Turn::Straight => return Some(Finding3::NoCorner { facet, corner: at }),
                turn if turn != anticlockwise => {
                    return Some(Finding3::ReflexCorner { facet, corner: at });
                }
                _ => revolutions += usize::from(order3(p, q).is_lt() && order3(r, q).is_lt()),
            }
        }
        (revolutions != 1).then_some(Finding3::FacetWinding { facet, revolutions })
    }

    /// Step 4.
    fn edge_faults(&self) -> Vec<Finding3> {
        let surface = self.surface;
        let mut findings = Vec::new();
        let mut reflex = 0;
        for side in 0..surface.side_count() as u32 {
            let twin = surface.twin(side);
            if twin < side {
                continue;
            }
            let [a, b, c] = self.plane(side);
            let [_, _, apex] = self.plane(twin);
            let (from, to) = (surface.origin(side), surface.target(side));
            let facets = [side, twin].map(|side| surface.facets[side as usize]);
            match self.scale.side(a, b, c, apex) {
                Side::Below => {}
                Side::On => findings.push(Finding3::CoplanarFacets { from, to, facets }),
                Side::Above => {
                    reflex += 1;
                    findings.push(Finding3::ReflexEdge { from, to, facets });
                }
            }
        }
        if reflex == surface.side_count() / 2 {
            findings = vec![Finding3::InsideOut];
        }
        findings
    }

    /// Step 5.
    fn outline_goes_round_once(&self, facing: &Facing) -> Result<(), Vec<Finding3>> {
        let surface = self.surface;
        let is_upper = |facet: u32| facing[facet as usize] == Turn::Left;
        let mut outline: Vec<u32> = (0..surface.side_count() as u32)
            .filter(|&side| {
                is_upper(surface.facets[side as usize]) && !is_upper(surface.facet_beyond(side))
            })
            .collect();
        outline.sort_unstable_by_key(|&side| surface.origin(side));
        let mut findings = Vec::new();
        for pair in outline.windows(2) {
            let [vertex, other] = [pair[0], pair[1]].map(|side| surface.origin(side));
            if vertex == other {
                findings.push(Finding3::OutlineBreaks { vertex });
            }
        }
        let mut revolutions = 0;
        for &side in &outline {
            let vertex = surface.target(side);
            let after = outline.binary_search_by_key(&vertex, |&side| surface.origin(side));
            let Ok(after) = after.map(|place| surface.target(outline[place])) else {
                findings.push(Finding3::OutlineBreaks { vertex });
                continue;
            };
            let corners = [surface.origin(side), vertex, after].map(|id| self.at(id));
            let [p, q, r] = corners.map(|p| shadow(Axis::Z, p));
            let [a, b, c] = corners;
            match self.scale.turn(Axis::Z, a, b, c) {
                Turn::Left => {}
                Turn::Straight if order(p, q) == order(q, r) => {}
                _ => findings.push(Finding3::OutlineBreaks { vertex }),
            }
            revolutions += usize::from(order(p, q).is_lt() && order(r, q).is_lt());
        }
        verdict(findings)?;
        if revolutions != 1 {
            return Err(vec![Finding3::OutlineWinding { revolutions }]);
        }
        Ok(())
    }
}

/// Every corner with the one before it and the one after it.
fn triples(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let k = corners.len();
    (0..k).map(move |i| [(i + k - 1) % k, i, (i + 1) % k].map(|j| corners[j]))
}
