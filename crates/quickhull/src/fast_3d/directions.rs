//! A map from directions to how far the points certainly reach.
//!
//! From a centre inside a polytope, every direction meets its surface once. The directions are divided into cells, those
//! of a grid on each face of a cube around the centre. The part of the polytope within a cell's cone is replaced by a
//! smaller one with a flat top, so that one product tells whether a point is certainly inside:
//!
//! ```text
//!      surface of the polytope
//!         __.--*--.__                *  where the rays to the corners of a cell leave the polytope
//!       *'-----------'*              -  the flat top: below all of these. The pyramid from the
//!        \           /                  centre to it lies within the polytope, which is convex
//!         \         /
//!          \  cell /                 a point costs three differences, one quotient to find its cell,
//!           \     /                  and three products, however many facets the polytope has
//!            \   /
//!           centre
//! ```
//!
//! # Proof that a point found inside is inside, and not extreme
//!
//! All coordinates of corners and of the centre are at most M in magnitude, ε = 2⁻⁵³, "off by t" means a distance of at most
//! t along each axis, and distances below are in the maximum norm.
//!
//! 1. *Exits.* The ray q leaves through some triangle abc, which a walk finds. Its weights are computed with whatever
//!    error, made not negative and to have the sum 1 ± 4 ε, so e = Σ λ v is off by at most 32 ε M from a point of the
//!    triangle. The *residual* ρ is the distance from e to the point s·q of the ray, computed, off by 8 ε M. So s·q is
//!    within ρ + 40 ε M of the polytope. A walk that goes astray only makes ρ large.
//! 2. *Room.* The exits along the six axes show that the polytope holds an octahedron, off by as much, hence a cube of
//!    half side r about the centre, where r = ⅓ of the least exit minus ρ + 40 ε M.
//! 3. *Shrinking.* For a point x within t of the polytope and 0 < m < 1, (1-m)·x is within t of (1-m) times a point of it,
//!    about which the polytope holds a cube of half side m r. So (1-m)·x is in the polytope, with m r - t to
//!    spare.
//! 4. *Flat top.* The top of a cell lies below (1-m) s q for all four corners q, so the pyramid lies in the polytope
//!    with m r - ρ - 40 ε M to spare.
//! 5. *Points.* Let p have a distance of at most 2 M from the centre along each axis. Its cell comes from at most 10 roundings
//!    of quotients up to 1, and from a scaling by 1 - 16 ε that keeps it on the face, so p is off by at most 64 ε M from
//!    a point of that cell's cone. The limit of the height below the top is lowered for its rounding (`below`).
//! 6. So p is in the interior if m r ≥ ρ + 128 ε M. `View::of` chooses m r ≥ 2048 ε M, and a cell with
//!    2 ρ > m r at a corner stays unknown.
//!
//! An interior point is not extreme, not even where it has copies.
//!
//! **Points in a facet.** A lattice, or points on the faces of a cube, have most points exactly in the planes of facets, where
//! no rounded top is low enough. If the rays to all four corners of a cell, moved outward by `CLEARANCE` of a cell's
//! width, leave through one plane x = const (or y, z), its own cell's four rays do so with room all around, and then the exact comparison x ≤
//! const is the test: a point of the cell that passes it is inside, or in the facet's plane and inside the facet, by a margin that
//! is far more than 128 ε M. Such a point is not extreme either.
//!
//! **Range.** Used only if 2⁻⁴⁰⁰ ≤ r, M ≤ 2⁴⁰⁰ and r ≥ 2⁻²⁸ M, so that nothing overflows, and a product that
//! underflows is off by 2⁻¹⁰⁷⁴, far less than ε times what it is added to.

mod view;

use super::core::Core;
use super::discard::count_inside;
use crate::blocks::{BLOCK, places};
use geometry_core::mesh::TriMesh;
use geometry_core::{Point3, Points};
use view::View;

/// A cell: a point p is certainly inside if normal · p ≤ limit.
#[derive(Clone, Copy, Debug)]
struct Cell {
    normal: Point3,
    limit: f64,
}

impl Cell {
    /// Nothing is certain.
    const UNKNOWN: Self = Self {
        normal: [0.0; 3],
        limit: -1.0,
    };
}

/// The map. See the header.
#[derive(Debug)]
pub(super) struct DirectionMap {
    centre: Point3,
    /// Points further away than this along an axis are outside the polytope.
    reach: f64,
    /// The number of cells along a side of a face of the cube.
    side: f64,
    /// Half of that, less what keeps the last quotient in the last column; and half of it less a half, as numbers are
    /// rounded to the nearest integer.
    scale: f64,
    shift: f64,
    /// The number of the last cell.
    unknown: f64,
    /// 6 · side² cells, face by face, and one of which nothing is known.
    cells: Vec<Cell>,
    /// A body that holds many points, if one does.
    pub(super) core: Option<Core>,
}

/// What is computed of the points of a block.
#[derive(Debug)]
pub(super) struct Scratch {
    places: [u8; BLOCK],
    from_centre: [[f64; BLOCK]; 3],
    numbers: [f64; BLOCK],
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            places: [0; BLOCK],
            from_centre: [[0.0; BLOCK]; 3],
            numbers: [0.0; BLOCK],
        }
    }
}

/// Numbers are computed for a multiple of so many points: the width of the widest vectors.
const LANES: usize = 8;

/// 1.5 · 2⁵²: adding it rounds to an integer, which is then in the low bits.
const TO_INTEGER: f64 = 6755399441055744.0;

/// For so many points a second map pays, if it has a body.
const MANY: usize = 1 << 19;

impl DirectionMap {
    /// The map of the surface `mesh` of `points`, to be asked about `count` others; none if the surface is too flat for it, or
    /// its coordinates too large or too small.
    ///
    /// It looks from the middle of the corners. If no body about that holds many points of the sample, they may be close
    /// together compared to the polytope; then it also looks from among them, and takes what has such a body or finds more
    /// of them inside. For fewer points that does not pay where the first map finds most of the sample inside.
    pub(super) fn of(
        points: Points<'_, 3>,
        mesh: &TriMesh,
        count: usize,
        sample: &[Point3],
    ) -> Option<Self> {
        let side = cells_to_a_side(sample.len());
        let corners = mesh.triangles().flat_map(|triangle| mesh.corners(triangle));
        let middle = mean(corners.map(|id| points[id]));
        let from_middle = Self::from(middle, points, mesh, side, sample);
        let finds = |map: &Self| (map.core.is_some(), count_inside(map, sample));
        let finds_most = |map: &Self| 2 * count_inside(map, sample) >= sample.len();
        if let Some(map) = &from_middle
            && (map.core.is_some() || count < MANY && finds_most(map))
        {
            return from_middle;
        }
        let from_points = Self::from(median(sample), points, mesh, side, sample);
        let maps = [from_points, from_middle].into_iter().flatten();
        maps.max_by_key(finds)
    }

    fn from(
        centre: Point3,
        points: Points<'_, 3>,
        mesh: &TriMesh,
        side: usize,
        sample: &[Point3],
    ) -> Option<Self> {
        let view = View::of(points, mesh, centre)?;
        let mut cells = Vec::with_capacity(6 * side * side + 1);
        for face in 0..6 {
            view.cells_of_face(face, side, &mut cells);
        }
        let core = view.core(&cells, sample);
        cells.push(Cell::UNKNOWN);
        let (unknown, side) = ((cells.len() - 1) as f64, side as f64);
        let half = side / 2.0;
        Some(Self {
            centre: view.centre,
            reach: view.reach,
            side,
            scale: half - 8.0 * half * f64::EPSILON,
            shift: half - 0.5,
            unknown,
            cells,
            core,
        })
    }

    /// The points of a block that are not certainly inside, a bit for each. One with a coordinate that is not finite never
    /// is.
    ///
    /// Of a point that the core does not hold, nothing decides a branch, and the numbers of the cells are computed several at a
    /// time.
    #[inline(always)]
    pub(super) fn not_inside(&self, block: &[Point3; BLOCK], scratch: &mut Scratch) -> u64 {
        let asked = match &self.core {
            Some(core) => core.not_held(block),
            None => u64::MAX,
        };
        let mut count = 0;
        for place in places(asked) {
            scratch.places[count] = place as u8;
            let w = minus(block[place], self.centre);
            (0..3).for_each(|axis| scratch.from_centre[axis][count] = w[axis]);
            count += 1;
        }
        let [xs, ys, zs] = &scratch.from_centre;
        for slot in 0..count.next_multiple_of(LANES).min(BLOCK) {
            scratch.numbers[slot] = self.number([xs[slot], ys[slot], zs[slot]]);
        }
        let mut outside = 0;
        for (&place, &number) in scratch.places[..count].iter().zip(&scratch.numbers) {
            let p = block[usize::from(place) % BLOCK];
            let cell = self.cells[(number + TO_INTEGER).to_bits() as u32 as usize];
            let [x, y, z] = [0, 1, 2].map(|i| cell.normal[i] * p[i]);
            let is_inside = x + y + z <= cell.limit;
            outside |= u64::from(!is_inside) << place;
        }
        outside
    }

    /// The number of the cell in which a point w from the centre lies, or that of the last, of which nothing is known,
    /// where w is out of reach or zero.
    #[inline(always)]
    fn number(&self, w: Point3) -> f64 {
        let [x, y, z] = w.map(f64::abs);
        let by_x = (x >= y) & (x >= z);
        let by_y = y >= z;
        let pick = |for_x: f64, for_y: f64, for_z: f64| {
            let not_x = if by_y { for_y } else { for_z };
            if by_x { for_x } else { not_x }
        };
        let major = pick(w[0], w[1], w[2]);
        let inverse = 1.0 / major;
        let column = self.column(pick(w[1], w[2], w[0]) * inverse);
        let row = self.column(pick(w[2], w[0], w[1]) * inverse);
        let face = pick(0.0, 2.0, 4.0) + if major < 0.0 { 1.0 } else { 0.0 };
        let number = (face * self.side + row) * self.side + column;
        let is_known = (major.abs() > 0.0) & (major.abs() <= self.reach);
        // A coordinate that is NaN may be any of the three.
        let is_number = (number >= 0.0) & (number < self.unknown);
        if is_known & is_number {
            number
        } else {
            self.unknown
        }
    }

    /// The column, or row, of a quotient in -1..=1.
    #[inline(always)]
    fn column(&self, quotient: f64) -> f64 {
        (quotient * self.scale + self.shift + TO_INTEGER) - TO_INTEGER
    }
}

/// The most cells to the side of a face of the cube: more would not fit the cache, or not pay.
const FINEST: usize = 32;

/// How many cells to the side of a face of the cube pay for the hull of a sample of so many points.
fn cells_to_a_side(sample: usize) -> usize {
    if sample < 1 << 11 {
        8
    } else if sample < 1 << 13 {
        16
    } else {
        FINEST
    }
}

/// The middle coordinates of some of the points, each by itself.
fn median(points: &[Point3]) -> Point3 {
    let some = &points[..points.len().min(255)];
    [0, 1, 2].map(|axis| {
        let mut coordinates: Vec<f64> = some.iter().map(|p| p[axis]).collect();
        let middle = coordinates.len() / 2;
        *coordinates.select_nth_unstable_by(middle, f64::total_cmp).1
    })
}

fn mean(points: impl Iterator<Item = Point3>) -> Point3 {
    let add =
        |(sum, count): (Point3, f64), p: Point3| ([0, 1, 2].map(|i| sum[i] + p[i]), count + 1.0);
    let (sum, count) = points.fold(([0.0; 3], 0.0), add);
    sum.map(|x| x / count)
}

fn minus(p: Point3, q: Point3) -> Point3 {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}
