//! A polytope seen from a point inside: where rays leave it, and the cells of the map made of that.
//!
//! The steps of the proof in the parent's header are meant throughout.

use super::super::core::{Core, Shape};
use super::super::discard::count_inside;
use super::{Cell, minus};
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

/// A polytope seen from its centre.
pub(super) struct View<'a> {
    points: Points<'a, 3>,
    mesh: &'a TriMesh,
    pub(super) centre: Point3,
    pub(super) reach: f64,
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
    pub(super) fn of(points: Points<'a, 3>, mesh: &'a TriMesh, centre: Point3) -> Option<Self> {
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
    pub(super) fn core(&self, cells: &[Cell], sample: &[Point3]) -> Option<Core> {
        let normals = || cells.iter().map(|cell| self.normal_about_centre(cell));
        let best = [Shape::Ellipsoid, Shape::Box]
            .map(|shape| Core::below(shape, self.centre, self.axes, self.margin, normals()))
            .map(|core| (count_inside(&core, sample), core))
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
    pub(super) fn cells_of_face(&self, face: usize, side: usize, cells: &mut Vec<Cell>) {
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

/// u × v · w.
fn det(u: Point3, v: Point3, w: Point3) -> f64 {
    u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
}
