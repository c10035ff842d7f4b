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
//! no rounded top is low enough. If the rays to all four corners of a cell, moved outward by [`CLEARANCE`] of a cell's
//! width, leave through one plane x = const (or y, z), its own cell's four rays do so with room all around, and then the exact comparison x ≤
//! const is the test: a point of the cell that passes it is inside, or in the facet's plane and inside the facet, by a margin that
//! is far more than 128 ε M. Such a point is not extreme either.
//!
//! **Range.** Used only if 2⁻⁴⁰⁰ ≤ r, M ≤ 2⁴⁰⁰ and r ≥ 2⁻²⁸ M, so that nothing overflows, and a product that
//! underflows is off by 2⁻¹⁰⁷⁴, far less than ε times what it is added to.

use super::core::{BLOCK, Core, Shape, all_places};
use geometry_core::mesh::{SideId, TriMesh, TriangleId};
use geometry_core::{Point3, Points};

/// Half an ulp of one: ε.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// The least m: a part in 2³⁰ of the points is not worth more care.
const LEAST_MARGIN: f64 = 1.0 / (1 << 30) as f64;

/// Beyond this m the map would keep too much; it is not used.
const MOST_MARGIN: f64 = 1.0 / 128.0;

/// How far the rays of an exact cell are moved outward, in widths of a cell.
const CLEARANCE: f64 = 1.0 / 1024.0;

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

/// 1.5 · 2⁵²: adding it rounds to an integer, which is then in the low bits.
const TO_INTEGER: f64 = 6755399441055744.0;

impl DirectionMap {
    /// The map of the surface `mesh` of `points`, `side` cells to the side of each of the cube's faces; none if the surface
    /// is too flat for it, or its coordinates too large or too small.
    ///
    /// It looks from the middle of the corners. If no body about that holds many points of the sample, they may be close
    /// together compared to the polytope; then it also looks from among them, and takes what finds more of them inside.
    pub(super) fn of(
        points: Points<'_, 3>,
        mesh: &TriMesh,
        side: usize,
        sample: &[Point3],
    ) -> Option<Self> {
        let corners = mesh.triangles().flat_map(|triangle| mesh.corners(triangle));
        let middle = mean(corners.map(|id| points[id]));
        let from_middle = Self::from(middle, points, mesh, side, sample);
        if from_middle.as_ref().is_some_and(|map| map.core.is_some()) {
            return from_middle;
        }
        let from_points = Self::from(median(sample), points, mesh, side, sample);
        let maps = [from_points, from_middle].into_iter().flatten();
        maps.max_by_key(|map| map.count(sample))
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

    /// Keeps, of the first `kept` places of a block, those of points that are not certainly inside; returns how many.
    ///
    /// Nothing about a point decides a branch, and the numbers of the cells are computed several at a time.
    #[inline(always)]
    pub(super) fn keep_outside(
        &self,
        block: &[Point3],
        places: &mut [u8; BLOCK],
        kept: usize,
    ) -> usize {
        let mut from_centre = [[0.0; BLOCK]; 3];
        for (slot, &place) in places[..kept].iter().enumerate() {
            let w = minus(block[usize::from(place)], self.centre);
            (0..3).for_each(|axis| from_centre[axis][slot] = w[axis]);
        }
        let [xs, ys, zs] = &from_centre;
        let mut numbers = [0.0; BLOCK];
        for slot in 0..kept.next_multiple_of(4).min(BLOCK) {
            numbers[slot] = self.number([xs[slot], ys[slot], zs[slot]]);
        }
        let mut outside = 0;
        for (slot, &number) in numbers[..kept].iter().enumerate() {
            let place = places[slot];
            let p = block[usize::from(place)];
            let cell = self.cells[(number + TO_INTEGER).to_bits() as u32 as usize];
            let [x, y, z] = [0, 1, 2].map(|i| cell.normal[i] * p[i]);
            let is_inside = x + y + z <= cell.limit;
            places[outside] = place;
            outside += usize::from(!is_inside);
        }
        outside
    }

    /// How many of the points are certainly inside.
    fn count(&self, points: &[Point3]) -> usize {
        let blocks = points.chunks(BLOCK);
        let outside = blocks.map(|block| {
            let mut places = all_places();
            self.keep_outside(block, &mut places, block.len())
        });
        points.len() - outside.sum::<usize>()
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
        if is_known { number } else { self.unknown }
    }

    /// The column, or row, of a quotient in -1..=1.
    #[inline(always)]
    fn column(&self, quotient: f64) -> f64 {
        (quotient * self.scale + self.shift + TO_INTEGER) - TO_INTEGER
    }
}

/// A polytope seen from its centre.
struct View<'a> {
    points: Points<'a, 3>,
    mesh: &'a TriMesh,
    centre: Point3,
    reach: f64,
    /// The greatest distance from the centre along each axis.
    axes: Point3,
    /// M of the proof.
    largest: f64,
    /// The half side r of a cube about the centre within the polytope.
    room: f64,
    /// m of the proof.
    margin: f64,
    start: TriangleId,
}

/// Where a ray leaves the polytope.
#[derive(Clone, Copy)]
struct Exit {
    /// The multiple s of the ray.
    at: f64,
    /// ρ of the proof.
    residual: f64,
    triangle: TriangleId,
}

impl<'a> View<'a> {
    /// The view from `centre`; none if that is not well inside, or the numbers are out of range.
    fn of(points: Points<'a, 3>, mesh: &'a TriMesh, centre: Point3) -> Option<Self> {
        let start = mesh.triangles().next()?;
        let corners = mesh.triangles().flat_map(|triangle| mesh.corners(triangle));
        let coordinates = corners.flat_map(|id| points[id]);
        let largest = coordinates.fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut view = Self {
            points,
            mesh,
            centre,
            reach: 0.0,
            axes: [0.0; 3],
            largest,
            room: 0.0,
            margin: 0.0,
            start,
        };
        for triangle in mesh.triangles() {
            for p in view.corners(triangle) {
                view.axes = [0, 1, 2].map(|i| view.axes[i].max(p[i].abs()));
            }
        }
        view.reach = view.axes.into_iter().fold(0.0, f64::max);
        let mut least = f64::INFINITY;
        let mut residual = 0.0_f64;
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let mut q = [0.0; 3];
                q[axis] = sign;
                let exit = view.exit(q, start)?;
                least = least.min(exit.at);
                residual = residual.max(exit.residual);
            }
        }
        view.room = least / 3.0 - residual - 64.0 * ROUNDING * largest;
        let in_range = |x: f64| (x >= 2.0_f64.powi(-400)) & (x <= 2.0_f64.powi(400));
        let usable =
            in_range(view.room) && in_range(largest) && view.room >= largest * 2.0_f64.powi(-28);
        view.margin = (1024.0 * ROUNDING * largest / view.room).max(LEAST_MARGIN) * 2.0;
        (usable && view.margin <= MOST_MARGIN).then_some(view)
    }

    /// The body that holds more of the sample, if it is at least a quarter of it.
    fn core(&self, cells: &[Cell], sample: &[Point3]) -> Option<Core> {
        let normals = || cells.iter().map(|cell| self.normal_about_centre(cell));
        let best = [Shape::Ellipsoid, Shape::Box]
            .map(|shape| Core::below(shape, self.centre, self.axes, self.margin, normals()))
            .map(|core| (core.count(sample), core))
            .into_iter()
            .max_by_key(|&(count, _)| count)?;
        (4 * best.0 >= sample.len()).then_some(best.1)
    }

    /// The n for which the cell's points satisfy n · w ≤ 1; infinite for a cell of which nothing is known.
    fn normal_about_centre(&self, cell: &Cell) -> Point3 {
        if cell.normal == [0.0; 3] {
            return [f64::INFINITY; 3];
        }
        let [x, y, z] = [0, 1, 2].map(|i| cell.normal[i] * self.centre[i]);
        cell.normal.map(|n| n / (cell.limit - x - y - z))
    }

    /// The corners relative to the centre.
    fn corners(&self, triangle: TriangleId) -> [Point3; 3] {
        let corners = self.mesh.corners(triangle);
        corners.map(|id| minus(self.points[id], self.centre))
    }

    /// The exit of the ray q, by a walk from the triangle `start`; none if it does not get there.
    fn exit(&self, q: Point3, start: TriangleId) -> Option<Exit> {
        let mut triangle = start;
        for _ in 0..self.mesh.len().min(MOST_STEPS) {
            let [a, b, c] = self.corners(triangle);
            // The volumes of q with each side: which side of the plane through it and the centre the ray is on.
            let weights = [det(q, b, c), det(q, c, a), det(q, a, b)];
            let (mut least, mut opposite) = (0.0, 3);
            for (corner, &weight) in weights.iter().enumerate() {
                if weight < least {
                    (least, opposite) = (weight, corner);
                }
            }
            if opposite == 3 {
                return self.exit_through(triangle, q, [a, b, c], weights);
            }
            let side: SideId = triangle.side([1, 2, 0][opposite]);
            triangle = self.mesh.twin(side).triangle();
        }
        None
    }

    /// Step 1 of the proof, for weights that are not negative.
    fn exit_through(
        &self,
        triangle: TriangleId,
        q: Point3,
        [a, b, c]: [Point3; 3],
        weights: [f64; 3],
    ) -> Option<Exit> {
        let sum = weights[0] + weights[1] + weights[2];
        let weights = weights.map(|weight| weight / sum);
        let e = [0, 1, 2].map(|i| weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i]);
        let major = (0..3).fold(
            0,
            |most, i| if q[i].abs() > q[most].abs() { i } else { most },
        );
        let at = e[major] / q[major];
        let gaps = [0, 1, 2].map(|i| (e[i] - at * q[i]).abs());
        let residual = gaps.into_iter().fold(0.0, f64::max);
        // NaN, from an overflow or a sum of zero, ends here.
        (at > 0.0 && residual < at).then_some(Exit {
            at,
            residual,
            triangle,
        })
    }

    /// The cells of one face of the cube, row by row.
    fn cells_of_face(&self, face: usize, side: usize, cells: &mut Vec<Cell>) {
        let width = 2.0 / side as f64;
        let at = |place: usize| place as f64 * width - 1.0;
        let mut start = self.start;
        let mut row_of_exits = |row: usize| {
            let mut exits = Vec::with_capacity(side + 1);
            for column in 0..=side {
                let exit = self.exit(ray(face, at(column), at(row)), start);
                start = exit.map_or(start, |exit| exit.triangle);
                exits.push(exit);
            }
            exits
        };
        let mut below = row_of_exits(0);
        for row in 0..side {
            let above = row_of_exits(row + 1);
            for column in 0..side {
                let exits = [
                    below[column],
                    below[column + 1],
                    above[column],
                    above[column + 1],
                ];
                let place = Place {
                    face,
                    u: at(column),
                    v: at(row),
                    width,
                };
                cells.push(self.cell(place, exits).unwrap_or(Cell::UNKNOWN));
            }
            below = above;
        }
    }

    fn cell(&self, place: Place, exits: [Option<Exit>; 4]) -> Option<Cell> {
        let [p, q, r, s] = exits;
        let exits = [p?, q?, r?, s?];
        if let Some(cell) = self.exact_cell(&place, exits) {
            return Some(cell);
        }
        // Step 4: the reciprocals of the shrunk exits, at each corner, from below.
        let slack = self.margin * self.room;
        if exits.iter().any(|exit| 2.0 * exit.residual > slack) {
            return None;
        }
        let [p, q, r, s] = exits.map(|exit| 1.0 / (exit.at * (1.0 - self.margin)));
        let along_u = (q - p + s - r) / (2.0 * place.width);
        let along_v = (r - p + s - q) / (2.0 * place.width);
        let (u, v) = (place.u, place.v);
        let (u_end, v_end) = (u + place.width, v + place.width);
        let excess = |g: f64, u: f64, v: f64| g - along_u * u - along_v * v;
        let corners = [
            excess(p, u, v),
            excess(q, u_end, v),
            excess(r, u, v_end),
            excess(s, u_end, v_end),
        ];
        let level = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let size = level.abs() + along_u.abs() + along_v.abs();
        let normal = from_face(place.face, level + 16.0 * ROUNDING * size, along_u, along_v);
        Some(Cell {
            normal,
            limit: below(normal, self.centre, self.largest, self.reach),
        })
    }

    /// A cell all of whose rays leave through one plane on which a coordinate is constant.
    fn exact_cell(&self, place: &Place, exits: [Exit; 4]) -> Option<Cell> {
        let axis = place.face / 2;
        let level = self.constant(exits[0].triangle, axis)?;
        let moved = CLEARANCE * place.width;
        let (low, high) = (-moved, place.width + moved);
        let corners = [(low, low), (high, low), (low, high), (high, high)];
        for ((u, v), exit) in corners.into_iter().zip(exits) {
            let exit = self.exit(ray(place.face, place.u + u, place.v + v), exit.triangle)?;
            let is_clear = exit.residual <= moved * self.room / 1024.0;
            if self.constant(exit.triangle, axis)? != level || !is_clear {
                return None;
            }
        }
        let sign = if place.face.is_multiple_of(2) {
            1.0
        } else {
            -1.0
        };
        let mut normal = [0.0; 3];
        normal[axis] = sign;
        Some(Cell {
            normal,
            limit: sign * level,
        })
    }

    /// The coordinate that all corners have in common along an axis.
    fn constant(&self, triangle: TriangleId, axis: usize) -> Option<f64> {
        let [a, b, c] = self.mesh.corners(triangle).map(|id| self.points[id][axis]);
        (a == b && a == c).then_some(a)
    }
}

/// More steps than a walk needs from the exit of a neighbouring ray.
const MOST_STEPS: usize = 1000;

/// The place of a cell: its face of the cube, its low corner, its width.
struct Place {
    face: usize,
    u: f64,
    v: f64,
    width: f64,
}

/// The ray to (u, v) on a face of the cube: the faces are +x, -x, +y, -y, +z, -z; u and v are the quotients of the next two
/// coordinates by the major one, cyclically.
fn ray(face: usize, u: f64, v: f64) -> Point3 {
    from_face(face, 1.0, u, v)
}

fn from_face(face: usize, major: f64, u: f64, v: f64) -> Point3 {
    let sign = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
    let [major, u, v] = [major, u, v].map(|x| sign * x);
    match face / 2 {
        0 => [major, u, v],
        1 => [v, major, u],
        _ => [u, v, major],
    }
}

/// The limit of normal · p for points with normal · (p - centre) ≤ 1, less all that rounding may do to it.
fn below(normal: Point3, centre: Point3, largest: f64, reach: f64) -> f64 {
    let size: f64 = normal.into_iter().map(f64::abs).sum();
    let level = 1.0 + normal[0] * centre[0] + normal[1] * centre[1] + normal[2] * centre[2];
    level - 32.0 * ROUNDING * (1.0 + size * (largest + reach))
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

/// u × v · w.
fn det(u: Point3, v: Point3, w: Point3) -> f64 {
    u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
}
