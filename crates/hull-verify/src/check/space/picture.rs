//! Half of a convex surface, seen from above: the shadow of its upper or lower facets, in which points are located.
//!
//! A walk to a point p crosses, from any facet, a side that has the shadow of p strictly on its far side, until
//! there is none. Over p the plane of the facet entered is strictly below that of the facet left (above, in the lower
//! half), because the edge between them is convex; so the walk visits no facet twice, and stops. Where it starts is a
//! guess from a grid of the places where earlier walks ended: a wrong guess costs time and nothing else.

use super::shape::{Facing, Shape};
use crate::arithmetic::Turn;
use crate::arithmetic::scale::shadow;
use geometry_core::{Axis, Point3};

/// The facet over or under a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stab {
    pub(super) facet: u32,
    /// The corner of it with the same shadow as the point, if there is one.
    pub(super) corner: Option<u32>,
    /// Whether the shadow of the point is on the rim of the picture.
    pub(super) on_rim: bool,
}

/// Which half of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Half {
    Upper,
    Lower,
}

/// Where the shadow of a point is with regard to the shadow of a facet.
enum Spot {
    /// Strictly on the far side of this side of the facet.
    Beyond(u32),
    /// Inside, or on these sides.
    Within(Vec<u32>),
}

#[derive(Debug)]
pub(super) struct Picture<'a> {
    shape: Shape<'a>,
    facing: &'a Facing,
    /// How the facets of this half turn in the shadow.
    inward: Turn,
    /// Whether a point is a vertex on the rim.
    rim: Vec<bool>,
    hints: Hints,
}

impl<'a> Picture<'a> {
    /// The picture of one half of a surface that passed steps 1 to 5. O(m + n) for m sides.
    pub(super) fn new(shape: Shape<'a>, facing: &'a Facing, half: Half) -> Self {
        let inward = match half {
            Half::Upper => Turn::Left,
            Half::Lower => Turn::Right,
        };
        let surface = shape.surface;
        let mut picture = Self {
            shape,
            facing,
            inward,
            rim: vec![false; shape.points.len()],
            hints: Hints::new(shape, facing, inward),
        };
        for side in 0..surface.side_count() as u32 {
            if picture.has(surface.facets[side as usize]) && picture.is_on_rim(side) {
                picture.rim[surface.origin(side) as usize] = true;
            }
        }
        picture
    }

    /// The facet over or under p, or a side of the surface on the rim that has the shadow of p strictly on its far
    /// side.
    pub(super) fn stab(&mut self, p: Point3) -> Result<Stab, u32> {
        let cell = self.hints.cell(p);
        let mut facet = self.hints.ends[cell];
        loop {
            match self.spot(facet, p) {
                Spot::Beyond(side) if self.is_on_rim(side) => return Err(side),
                Spot::Beyond(side) => facet = self.shape.surface.facet_beyond(side),
                Spot::Within(sides) => {
                    self.hints.ends[cell] = facet;
                    return Ok(self.stab_in(facet, &sides, p));
                }
            }
        }
    }

    fn has(&self, facet: u32) -> bool {
        self.facing[facet as usize] == self.inward
    }

    /// Whether a side of a facet of this half has a facet of another beyond it.
    fn is_on_rim(&self, side: u32) -> bool {
        !self.has(self.shape.surface.facet_beyond(side))
    }

    /// Finds the wedge at the first corner that p is in, then asks on which side of the chord p is. O(log k) turns
    /// for k corners.
    ///
    /// ```text
    ///          i + 1
    ///       . - ' \
    ///     0  p     \ chord
    ///       ` - . . i
    /// ```
    fn spot(&self, facet: u32, p: Point3) -> Spot {
        let corners = self.shape.surface.corners(facet);
        let first_side = self.shape.surface.first_side(facet);
        let last = corners.len() - 1;
        let turn = |i: usize, j: usize| {
            let [a, b] = [i, j].map(|i| self.shape.at(corners[i]));
            self.shape.scale.turn(Axis::Z, a, b, p)
        };
        let is_outward = |turn: Turn| turn != self.inward && turn != Turn::Straight;
        let [along_first, along_last] = [turn(0, 1), turn(last, 0)];
        if is_outward(along_first) {
            return Spot::Beyond(first_side);
        }
        if is_outward(along_last) {
            return Spot::Beyond(first_side + last as u32);
        }
        let (mut i, mut end) = (1, last);
        while end - i > 1 {
            let middle = i.midpoint(end);
            if is_outward(turn(0, middle)) {
                end = middle;
            } else {
                i = middle;
            }
        }
        let along_chord = turn(i, i + 1);
        if is_outward(along_chord) {
            return Spot::Beyond(first_side + i as u32);
        }
        let tested = [(along_first, 0), (along_last, last), (along_chord, i)];
        let touched = tested
            .into_iter()
            .filter(|&(turn, _)| turn == Turn::Straight)
            .map(|(_, i)| first_side + i as u32);
        Spot::Within(touched.collect())
    }

    /// For p in the shadow of `facet`, on those of `sides`.
    fn stab_in(&self, facet: u32, sides: &[u32], p: Point3) -> Stab {
        let surface = self.shape.surface;
        let ends = sides
            .iter()
            .flat_map(|&side| [surface.origin(side), surface.target(side)]);
        let flat = |p: Point3| shadow(Axis::Z, p);
        let corner = { ends }.find(|&id| flat(self.shape.at(id)) == flat(p));
        Stab {
            facet,
            corner,
            on_rim: sides.iter().any(|&side| self.is_on_rim(side))
                || corner.is_some_and(|id| self.rim[id as usize]),
        }
    }
}

/// For each cell of a grid, the facet where a walk to a point of that cell ended last. The arithmetic is rounded:
/// it decides where a walk starts, never where it ends.
#[derive(Debug)]
struct Hints {
    low: [f64; 2],
    cells_per_unit: [f64; 2],
    cells_per_row: usize,
    ends: Vec<u32>,
}

impl Hints {
    /// Each cell begins with a facet that has its first corner there, or near there.
    fn new(shape: Shape<'_>, facing: &Facing, inward: Turn) -> Self {
        let facets = (0..).zip(facing).filter(|&(_, &turn)| turn == inward);
        let corner = |facet: u32| shape.at(shape.surface.corners(facet)[0]);
        let cells_per_row = facets.clone().count().isqrt().clamp(1, 512);
        let axis = |i: usize| {
            let values = shape.surface.origins.iter().map(|&id| shape.at(id)[i]);
            let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), x| {
                (low.min(x), high.max(x))
            });
            (low, cells_per_row as f64 / (high - low))
        };
        let ((x, per_x), (y, per_y)) = (axis(0), axis(1));
        let mut hints = Self {
            low: [x, y],
            cells_per_unit: [per_x, per_y],
            cells_per_row,
            ends: vec![u32::MAX; cells_per_row * cells_per_row],
        };
        let mut latest = u32::MAX;
        for (facet, _) in facets {
            let cell = hints.cell(corner(facet));
            hints.ends[cell] = facet;
            latest = facet;
        }
        for end in &mut hints.ends {
            if *end == u32::MAX {
                *end = latest;
            }
            latest = *end;
        }
        hints
    }

    fn cell(&self, p: Point3) -> usize {
        // A conversion to an integer saturates, and takes NaN to zero.
        let [column, row] = [0, 1].map(|i| {
            let cell = ((p[i] - self.low[i]) * self.cells_per_unit[i]) as usize;
            cell.min(self.cells_per_row - 1)
        });
        row * self.cells_per_row + column
    }
}
