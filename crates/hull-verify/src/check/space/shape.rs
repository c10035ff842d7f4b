//! The shape of a surface: steps 3 to 6 of the argument ([`super`]).

use super::finding3::{Finding3, verdict};
use super::surface::Surface;
use crate::arithmetic::scale::{Scale, Side, order3, shadow};
use crate::arithmetic::{Turn, order};
use crate::check::cycle::{Fault, convex_outline};
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
        let outline = (0..surface.side_count() as u32)
            .filter(|&side| {
                is_upper(surface.facets[side as usize]) && !is_upper(surface.facet_beyond(side))
            })
            .map(|side| [surface.origin(side), surface.target(side)])
            .collect();
        let turn = |a, b, c| self.scale.turn(Axis::Z, self.at(a), self.at(b), self.at(c));
        let flat = |id| shadow(Axis::Z, self.at(id));
        convex_outline(outline, turn, |a, b| order(flat(a), flat(b))).map_err(|fault| match fault {
            Fault::Breaks(vertices) => vertices
                .into_iter()
                .map(|vertex| Finding3::OutlineBreaks { vertex })
                .collect(),
            Fault::Winding(revolutions) => vec![Finding3::OutlineWinding { revolutions }],
        })
    }
}

/// Every corner with the one before it and the one after it.
fn triples(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    let k = corners.len();
    (0..k).map(move |i| [(i + k - 1) % k, i, (i + 1) % k].map(|j| corners[j]))
}
