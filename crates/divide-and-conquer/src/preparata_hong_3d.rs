//! Preparata and Hong's hull in space, as Day implements it: sort, halve, and join the hulls of the halves by a wrap.
//!
//! **Papers.** F. P. Preparata and S. J. Hong, "Convex hulls of finite sets of points in two and three dimensions",
//! *Communications of the ACM* 20(2), 87–93, 1977. A. M. Day, "The implementation of an algorithm to find the convex
//! hull of a set of three-dimensional points", *ACM Transactions on Graphics* 9(1), 105–132, 1990.
//!
//! **Essence.**
//!
//! 1. Sort the points and split them in two halves of equal size, which a plane separates.
//! 2. Find the hull of each half in the same way; one point is its own hull.
//! 3. With each hull in space goes the hull of its shadow on the x-y plane. Join the two shadows by their supporting
//!    lines (`shadow`). Each of the lines is the shadow of an edge of the merged hull: a *bridge*.
//! 4. From one bridge, make triangle after triangle until the bridge comes back to where it was (`wrap`). The third
//!    corner of each is the end of an edge of either half, the one that turns furthest outwards.
//! 5. Free the edges that the wrap has hidden, and sew its triangles in (`seam`).
//! 6. When all is merged, list the facets by a closed path that spirals over the surface (`faces`).
//!
//! The figure of the wrap is in `wrap.rs`, that of an edge record in `edges.rs`.
//!
//! **Bound.** O(n log n): a merge is linear. A search round a vertex starts at the edge after the one the wrap arrived
//! by, stops at the first edge that is no better, and resumes where it stopped when the wrap has moved on at the other
//! end. What it passes is hidden for good, so a merge of n points asks at most one question for each edge that it hides,
//! seen from either end, and three for each triangle: two to see that neither search goes on, and one between the two
//! winners; and one for each edge at the ends of the first bridge. Day suspected a quadratic merge where the wrap comes
//! through one vertex many times; with this rule there is none, because the sectors of the visits are disjoint. It is
//! there if every search starts anew: [`preparata_hong_rescan`] is that variant. Recursion is ⌈log₂ n⌉ deep. Space: 16
//! bytes a point for the shadow, 32 an edge, and the wrap.
//!
//! **Counted.** At the top merge of 4 m + 2 points whose wrap comes through one vertex m times: 5.00 n questions, less a
//! constant, and 0.126 n² if every search starts anew. Of 4 m + 2 points of which one stays the pivot throughout: 3.50 n and
//! 0.250 n². On a sphere: about 5 a triangle, at most 2.5 times as many with every search from the start.
//!
//! **Invariants.**
//!
//! 1. The halves are separated in the order by x, y, z, which is the order by x of the points as [`Perturbed`] moves
//!    them. No two of these have one x, no three one line, no four one plane, and no three shadows one line.
//! 2. After a range of the sorted order is conquered, its edges are those of the hull of its (moved) points: linked
//!    round each vertex in order, and all facets are triangles. Two points have the one edge, three points the three
//!    edges of a triangle with two sides.
//! 3. The ring of a range runs anticlockwise through the vertices of the hull of its shadow, which are vertices of the
//!    hull too.
//! 4. Seen from outside, with the first half up, the wrap runs to the left. All candidates are on the inner side of
//!    the last triangle's plane, so that comparing two of them is one orientation: of the bridge and the two.
//! 5. A bridge has two triangles, so each occurs once: the wrap is complete when the first one recurs.
//! 6. A vertex that the wrap went through several times loses only the edges in the sectors between arrival and
//!    departure. A vertex it did not go through loses all or none.
//! 7. There are no records of hidden edges between merges.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When few points are extreme, quickhull throws most away at once, while here every point is
//! on a hull of every level until it is hidden.

use edges::Dart;
use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::TriMesh;
use geometry_core::sort::merge_sort;
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Point3, Points, Silent};
use questions::Oriented;
use surface::{Fault, Policy, Scan, Surface};

pub mod cotangent;
mod edges;
mod faces;
mod listing;
mod parallel;
mod questions;
mod seam;
mod shadow;
mod surface;
mod wrap;

pub use listing::{Listings, listings};
pub use parallel::{PARALLEL_DEPARTURES, preparata_hong_parallel};
pub use surface::MergeRecord;

/// Where this file departs from Day's paper, and why.
pub const DEPARTURES: &[&str] = &[
    "axes are renamed: Day splits by y, this file by x (then y, then z); the shadow is that on the x-y plane for both",
    "angles are not computed: which of two candidates turns further is the orientation of the bridge and the two; \
     Day's cotangents are in day_cotangent",
    "points of equal coordinates, collinear and coplanar points, which Day leaves open, are told apart by a symbolic \
     perturbation, as he proposes; copies are dropped after the sort, and coplanar facets are merged at the end",
    "the recursion goes down to single points, where Day stops at four with a tetrahedron and adds up to three \
     dummy points to make that come out; merges with one, two and three points are no special case",
    "the search for a supporting line starts at the facing ends of the halves instead of at the extremes across, \
     so that no case distinction is needed",
    "a search does not look beyond an edge by which the wrap arrived at the vertex, where the next visit's edges begin",
    "hidden edges are freed after each merge, where Day keeps them all",
    "the links are changed after the wrap is complete instead of during it, so that the order of the changes needs \
     no care",
    "the spiral path is followed with a stack instead of recursion as deep as there are facets",
];

/// Where [`preparata_hong_rescan`] departs from Day's paper, and why.
pub const RESCAN_DEPARTURES: &[&str] = &[
    "at every step all edges at both ends of the bridge are looked at, to show what the resumed search saves",
    "otherwise as preparata-hong-3d",
];

/// Where [`preparata_hong_balan`] departs from the paper of Balan, Munjal and Rao, and why.
pub const BALAN_DEPARTURES: &[&str] = &[
    "edges are sorted by comparisons of the kernel, not by rounded angles in 360 buckets, which costs a logarithm of \
     the degree and makes the order right; the rule that takes the direction of an angle from the sign of its cosine, \
     which does not hold it, is not needed",
    "hulls are linked edge records, as in preparata-hong-3d, not hash maps from points to sets of points",
    "points are split by x, then y, then z, instead of by y alone",
    "edges that a search has passed are in the sort again when the same vertex is searched again, as with resumed \
     edges there would be nothing to sort",
    "degeneracies are treated as in preparata-hong-3d; the paper does not mention them",
];

/// Day's merge.
#[derive(Debug)]
pub(crate) struct Resumed;

impl Policy for Resumed {
    const SCAN: Scan = Scan::Resumed;
    const KEEPS_SHADOW: bool = true;
}

/// Every search starts anew.
#[derive(Debug)]
pub(crate) struct Rescanned;

impl Policy for Rescanned {
    const SCAN: Scan = Scan::Whole;
    const KEEPS_SHADOW: bool = true;
}

/// Balan, Munjal and Rao's: every search sorts, and every merge finds the hulls of the shadows anew.
#[derive(Debug)]
pub(crate) struct Sorted;

impl Policy for Sorted {
    const SCAN: Scan = Scan::Sorted;
    const KEEPS_SHADOW: bool = false;
}

/// The convex hull by Preparata and Hong's divide and conquer as Day implements it.
///
/// # Errors
///
/// [`HullError::TooManyPoints`] from 2²⁹ points on; [`HullError::Contradiction`] if a wrap does not close or does not
/// fit, which cannot happen with an exact kernel.
///
/// # Cost
///
/// O(n log n) lexicographic comparisons and orientations. For 10⁵ points on a sphere the merges ask 43 orientations a
/// point, and finding coplanar facets six more. Space: 50 bytes a point and 32 an edge, and the facets at the end.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// let cube: Vec<[f64; 3]> =
///     (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).chain([[0.5; 3]]).collect();
/// let hull = divide_and_conquer::preparata_hong_3d(Points::new(&cube)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 2, 3, 4, 5, 6, 7]);
/// assert_eq!(hull.facets().count(), 6);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn preparata_hong_3d<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    hull_by::<Resumed, K, O>(points, kernel, observer, &mut |_| {})
}

/// [`preparata_hong_3d`] with every search starting anew, the rule under which Day's suspicion of a quadratic merge is
/// right.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`].
///
/// # Cost
///
/// O(n²) orientations at worst; on random points about twice those of [`preparata_hong_3d`].
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let hull = divide_and_conquer::preparata_hong_rescan(Points::new(&corner)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.facets().count(), 4);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn preparata_hong_rescan<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    hull_by::<Rescanned, K, O>(points, kernel, observer, &mut |_| {})
}

/// The variant of A. Balan, G. Munjal and T. R. Rao: at every step the edges at both ends of the bridge are sorted by
/// angle, and in every merge the hulls of both shadows are found anew by Graham's scan.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`].
///
/// # Cost
///
/// O(n log² n + n² log n) orientations at worst.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let hull = divide_and_conquer::preparata_hong_balan(Points::new(&corner)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.facets().count(), 4);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn preparata_hong_balan<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    hull_by::<Sorted, K, O>(points, kernel, observer, &mut |_| {})
}

/// A way of merging, for [`merges`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variant {
    /// That of [`preparata_hong_3d`].
    Resumed,
    /// That of [`preparata_hong_rescan`].
    Rescanned,
    /// That of [`preparata_hong_balan`].
    Sorted,
}

impl Variant {
    /// All of them.
    pub const ALL: [Variant; 3] = [Variant::Resumed, Variant::Rescanned, Variant::Sorted];
}

/// What happened in each merge on the way to the hull of `points`; the merge at the top comes last.
///
/// Empty if the points do not span space.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`].
///
/// # Cost
///
/// That of the variant, and a record a point.
///
/// # Example
///
/// ```
/// use divide_and_conquer::preparata_hong_3d::{Variant, merges};
/// use geometry_core::{Exact, Points};
/// let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let merges = merges(Points::new(&corner)?, Variant::Resumed, &Exact)?;
/// // Two pairs, each joined by an edge, and the tetrahedron of four facets between the pairs.
/// assert_eq!(merges.iter().map(|merge| merge.facets).collect::<Vec<_>>(), [0, 0, 4]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn merges<K: Kernel3>(
    points: Points<'_, 3>,
    variant: Variant,
    kernel: &K,
) -> Result<Vec<MergeRecord>, HullError> {
    let mut records = Vec::new();
    let mut log = |record| records.push(record);
    match variant {
        Variant::Resumed => hull_by::<Resumed, K, _>(points, kernel, &mut Silent, &mut log)?,
        Variant::Rescanned => hull_by::<Rescanned, K, _>(points, kernel, &mut Silent, &mut log)?,
        Variant::Sorted => hull_by::<Sorted, K, _>(points, kernel, &mut Silent, &mut log)?,
    };
    Ok(records)
}

/// Darts, of which there are six a point, and merges, with two bits for notes, are counted in 32 bits.
const MOST_POINTS: usize = (1 << 29) - 1;

/// The hull under a policy; `log` hears of each merge.
fn hull_by<P: Policy, K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
    log: &mut impl FnMut(MergeRecord),
) -> Result<Hull3, HullError> {
    hull_of_order(points, kernel, |order| {
        let questions = Oriented(Perturbed(kernel));
        let mut surface = Surface::<P, _, _>::new(&order.points, &order.ids, &questions, observer);
        let vertices = surface.conquer(0..order.ids.len(), log)?;
        surface.into_mesh(vertices)
    })
}

/// The hull whose surface `solve` finds if the points span space.
fn hull_of_order<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    solve: impl FnOnce(&Order) -> Result<TriMesh, Fault>,
) -> Result<Hull3, HullError> {
    if points.len() > MOST_POINTS {
        let count = points.len();
        return Err(HullError::TooManyPoints { count });
    }
    if let Ok(flat) = AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        return Ok(flat);
    }
    let mesh = solve(&Order::of(points, kernel))?;
    Ok(Hull3::from_mesh(points, &mesh, kernel))
}

/// The distinct points in the order by x, y, z. A *place* is a position in it.
struct Order {
    /// The caller's index of each place: of copies the smallest.
    ids: Vec<u32>,
    /// The points themselves, so that neighbours in space are neighbours in memory.
    points: Vec<Point3>,
}

impl Order {
    fn of<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> Self {
        let mut ids: Vec<u32> = points.ids().collect();
        let mut scratch = vec![0; ids.len()];
        // Stable: of copies the smallest index comes first.
        merge_sort(&mut ids, &mut scratch, |p, q| {
            kernel.lexicographic3(points[p], points[q])
        });
        ids.dedup_by(|later, kept| kernel.lexicographic3(points[*later], points[*kept]).is_eq());
        let points = ids.iter().map(|&id| points[id]).collect();
        Self { ids, points }
    }
}

impl<P, Q, O> Surface<'_, P, Q, O> {
    /// The one hull that is left, with this many vertices, as triangles between the caller's indices.
    fn into_mesh(self, vertices: u32) -> Result<TriMesh, Fault> {
        // Euler's formula for triangles. All edges are those of the hull, by invariant 7.
        // The first place is on every hull; Day starts at the leftmost edge of the shadow's hull, too.
        let first = &self.places[0];
        if self.edges.live() + 6 != 3 * vertices as usize || !first.has_edges() {
            return Err(Fault::Tangled);
        }
        let start = Dart(first.spoke);
        let facets = faces::by_spiral(&self.edges, start, self.places.len())?;
        faces::mesh(&self.edges, &facets, self.ids)
    }
}
