//! Delaunay triangulations as lower hulls of points lifted to the paraboloid.
//!
//! **Source.** K. Q. Brown, "Voronoi diagrams from convex hulls", *Information Processing Letters* 9(5), 223–228,
//! 1979, by a sphere; H. Edelsbrunner and R. Seidel, "Voronoi diagrams and arrangements", *Discrete & Computational
//! Geometry* 1, 25–44, 1986, by the paraboloid; as P. Nathan describes it in "Obtaining the convex hull from a set
//! of points using the gift wrapping algorithm", 2015, figure 1.
//!
//! **Essence.**
//!
//! 1. Lift each point (x, y) to (x, y, x² + y²).
//! 2. Find the convex hull of the lifted points, by any method.
//! 3. Its facets that face downwards, seen from above, are the Delaunay triangles: a plane cuts the paraboloid
//!    above a circle, the points inside the circle are lifted to below the plane, and below a lower facet there is
//!    nothing.
//!
//! ```text
//!       *----------------*       upper hull: thrown away
//!        \              /
//!         \            /
//!          *_        _*          lower hull: joins neighbours
//!            '-*__*-'
//!    ---+--+---+--+---+--+---   points of a line, and above them their lifts
//! ```
//!
//! **Exactness.** No height is computed. x² + y² rounds: on points 10⁷ away from the origin, half of the orientations of
//! rounded lifts that matter have the wrong sign. The hull method asks a [`Lifted`] kernel instead, whose
//! orientation of four lifted points is the in-circle question about the points themselves.
//!
//! **Cocircular points.** They are lifted to one plane and come out as one facet with all of them as corners. It is cut
//! into the fan from its lexicographically smallest corner. So the triangulation depends on the places of the points
//! alone: not on their order, not on the hull method.
//!
//! **Bound.** That of the hull method for n points, all of them extreme, and O(n log n) for putting the triangles in
//! order. At most 2n - 5 triangles.
//!
//! **Invariants.**
//!
//! 1. All distinct points are vertices: the paraboloid is strictly convex.
//! 2. A facet faces downwards exactly if its shadow on the x-y plane, its corners anticlockwise seen from outside, runs
//!    clockwise. Upright facets, over rows of collinear points on the outline, have no shadow and are left out.
//! 3. Corners of a facet lie on a circle. So no three of them are collinear, and any fan is a triangulation.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When speed is all: the hull of the lifted points also has the upper facets, which are thrown
//! away. [`fast`] knows the in-circle test from the start, and gives the same triangulation.
//!
//! [`voronoi`] has the dual.

pub mod fast;
pub mod voronoi;

pub use fast::{fast_delaunay, fast_delaunay_counted, fast_delaunay_parallel};
pub use voronoi::{Voronoi, VoronoiEdge};

use geometry_core::{
    Axis, Hull3, HullError, InCircle, Kernel2, Kernel3, Lifted, Method, Point3, Points, Sign,
    Triangulation, delaunay_task,
};

const GUIBAS_STOLFI: &str = "L. Guibas and J. Stolfi, Primitives for the manipulation of general subdivisions and the \
    computation of Voronoi diagrams, ACM Transactions on Graphics 4, 74-123, 1985; R. A. Dwyer, A faster \
    divide-and-conquer algorithm for constructing Delaunay triangulations, Algorithmica 2, 137-151, 1987";

/// The methods of this crate that need no spatial method.
pub const METHODS: &[Method] = &[
    Method {
        slug: "fast-delaunay",
        title: "Delaunay triangulation by divide and conquer",
        citation: GUIBAS_STOLFI,
        departures: fast::DEPARTURES,
        cost: "O(n log n)",
        task: delaunay_task!(fast_delaunay, fast_delaunay_counted),
    },
    Method {
        slug: "fast-delaunay-parallel",
        title: "Delaunay triangulation by divide and conquer, on several processors",
        citation: GUIBAS_STOLFI,
        departures: fast::PARALLEL_DEPARTURES,
        cost: "that of fast-delaunay, most of it shared among the processors",
        task: delaunay_task!(fast_delaunay_parallel),
    },
];

/// Where this crate departs from Nathan's description, and why.
pub const DEPARTURES: &[&str] = &[
    "heights are not computed: the kernel answers about lifted points from their places in the plane",
    "whether a triangle faces downwards is told by the orientation of its shadow, not by a rounded normal",
    "facets over cocircular points are triangulated by a stated rule",
];

/// The Delaunay triangulation of `points` by the spatial hull method `hull`.
///
/// `hull` is given the lifted points and the kernel that knows them; the third coordinates are zero and mean nothing.
/// `kernel` must be exact. Of copies of a point the smallest index stands for all; points that are all collinear
/// have no triangles.
///
/// # Errors
///
/// Those of `hull`.
///
/// # Cost
///
/// That of `hull` for n points that are all extreme, O(n log n) time and O(n) space besides.
///
/// # Example
///
/// ```
/// use geometry_core::hull3::Solid;
/// use geometry_core::{Exact, Hull3, Kernel3, Lifted, Points};
/// use lifted_delaunay::delaunay_with;
///
/// // A method that knows only tetrahedra.
/// fn tetrahedron(points: Points<'_, 3>, kernel: &Lifted<Exact>) -> Result<Hull3, geometry_core::HullError> {
///     let turned = kernel.orient3(points[0], points[1], points[2], points[3]).is_positive();
///     let [a, b, c, d] = if turned { [0, 1, 2, 3] } else { [0, 2, 1, 3] };
///     let loops = vec![vec![a, c, b], vec![a, b, d], vec![b, c, d], vec![c, a, d]];
///     Ok(Hull3::Solid(Solid::from_loops(loops)))
/// }
///
/// let kite = [[0.0, 0.0], [1.0, -1.0], [4.0, 0.0], [1.0, 1.0]];
/// let triangulation = delaunay_with(Points::new(&kite)?, &Lifted(Exact), tetrahedron)?;
/// assert_eq!(triangulation.triangles(), [[0, 1, 3], [1, 2, 3]]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn delaunay_with<K: Kernel2 + InCircle>(
    points: Points<'_, 2>,
    kernel: &Lifted<K>,
    hull: impl FnOnce(Points<'_, 3>, &Lifted<K>) -> Result<Hull3, HullError>,
) -> Result<Triangulation, HullError> {
    let lifted: Vec<Point3> = points
        .as_slice()
        .iter()
        .map(|&[x, y]| [x, y, 0.0])
        .collect();
    let lifted = Points::new(&lifted)?;
    let faces = Faces {
        points: lifted,
        kernel,
    };
    let mut triangles = Vec::with_capacity(2 * points.len());
    match hull(lifted, kernel)? {
        // All points are cocircular, or collinear; which way the face runs is not said.
        Hull3::Planar(corners) => match faces.shadow(&corners) {
            Sign::Positive => faces.fan(corners, &mut triangles),
            Sign::Negative => faces.fan(reversed(&corners), &mut triangles),
            Sign::Zero => {}
        },
        solid_or_less => {
            let downward = solid_or_less
                .facets()
                .filter(|corners| faces.shadow(corners).is_negative());
            for corners in downward {
                faces.fan(reversed(corners), &mut triangles);
            }
        }
    }
    Ok(Triangulation::new(triangles))
}

fn reversed(corners: &[u32]) -> Vec<u32> {
    corners.iter().rev().copied().collect()
}

struct Faces<'a, K> {
    points: Points<'a, 3>,
    kernel: &'a K,
}

impl<K: Kernel3> Faces<'_, K> {
    /// The orientation of the shadow of a face with these corners. Any three of them tell (invariant 3).
    fn shadow(&self, corners: &[u32]) -> Sign {
        let [a, b, c] = [0, 1, 2].map(|i| self.points[corners[i]]);
        self.kernel.shadow(Axis::Z, a, b, c)
    }

    /// Cuts a face into triangles, its shadow being anticlockwise.
    fn fan(&self, mut corners: Vec<u32>, triangles: &mut Vec<[u32; 3]>) {
        let place = |i: &usize| self.points[corners[*i]];
        let by_place = |i: &usize, j: &usize| self.kernel.lexicographic3(place(i), place(j));
        let first = (0..corners.len()).min_by(by_place).unwrap_or(0);
        corners.rotate_left(first);
        let others = corners.windows(2).skip(1);
        triangles.extend(others.map(|edge| [corners[0], edge[0], edge[1]]));
    }
}
