//! Delaunay triangulations: where lifting meets the hull methods.

use geometry_core::{
    Counted, Exact, HullError, InCircle, Kernel2, Lifted, Method, Points, QuestionCounts, Silent,
    Tally, Task, Triangulation, delaunay_task,
};
use lifted_delaunay::{delaunay_with, fast_delaunay};

/// The methods that triangulate through a spatial hull.
pub(crate) const METHODS: &[Method] = &[Method {
    slug: "lifted-delaunay",
    title: "Delaunay triangulation as a lower hull",
    citation: "P. Nathan, Obtaining the convex hull from a set of points using the gift wrapping algorithm, 2015, \
               figure 1; H. Edelsbrunner and R. Seidel, Voronoi diagrams and arrangements, Discrete & Computational \
               Geometry 1, 25-44, 1986",
    departures: lifted_delaunay::DEPARTURES,
    cost: "O(n log n), that of preparata-hong-3d for n extreme points",
    task: delaunay_task!(lifted, lifted_counted),
}];

/// The Delaunay triangulation of `points`.
///
/// Exact for every finite input and the same for every order of the points: where more than three points lie on one
/// circle, their polygon is cut into the fan from its lexicographically smallest corner. Of equal points the smallest
/// index stands for all; collinear points have no triangles.
///
/// # Errors
///
/// [`HullError::NotFinite`] names the index and axis of a coordinate that is NaN or infinite.
///
/// # Cost
///
/// That of method `fast-delaunay`, O(n log n).
///
/// ```
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 3.0], [0.0, 0.0]];
/// let triangulation = hullkit::delaunay(&points)?;
/// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3], [2, 4, 3]]);
/// # Ok::<(), hullkit::HullError>(())
/// ```
pub fn delaunay(points: &[[f64; 2]]) -> Result<Triangulation, HullError> {
    fast_delaunay(Points::new(points)?)
}

/// By the spatial method that measured fastest: of the hull methods here `preparata-hong-3d` asks the fewest in-circle
/// questions when all points are extreme, about 39 a point at ten thousand points, where `incremental-conflict` asks 157
/// and the quickhulls need comparisons of heights besides, which have no fast filter on the paraboloid.
fn lifted(points: Points<'_, 2>) -> Result<Triangulation, HullError> {
    lifted_with(points, Exact)
}

fn lifted_counted(points: Points<'_, 2>) -> Result<(Triangulation, QuestionCounts), HullError> {
    let kernel = Counted::new(Exact);
    let triangulation = lifted_with(points, &kernel)?;
    Ok((triangulation, kernel.counts()))
}

fn lifted_with(
    points: Points<'_, 2>,
    kernel: impl Kernel2 + InCircle,
) -> Result<Triangulation, HullError> {
    delaunay_with(points, &Lifted(kernel), |lifted, kernel| {
        divide_and_conquer::preparata_hong_3d(lifted, kernel, &mut Silent)
    })
}

/// [`delaunay`] by a chosen spatial hull method; `None` if `method` is not one. The result is the same by every one.
///
/// # Errors
///
/// As [`delaunay`].
///
/// # Cost
///
/// That of the method for n points that are all extreme.
///
/// ```
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]];
/// let by_wrapping = hullkit::delaunay_by(hullkit::method("pivot-wrap").expect("registered"), &square);
/// assert_eq!(by_wrapping, Some(hullkit::delaunay(&square)));
/// let planar = hullkit::method("gs").expect("registered");
/// assert_eq!(hullkit::delaunay_by(planar, &square), None);
/// ```
pub fn delaunay_by(
    method: &Method,
    points: &[[f64; 2]],
) -> Option<Result<Triangulation, HullError>> {
    let Task::SpatialHull(hull) = &method.task else {
        return None;
    };
    let by_method = |points| {
        delaunay_with(points, &Lifted(Exact), |lifted, kernel| {
            (hull.tallied)(lifted, kernel, &mut Tally::default())
        })
    };
    Some(Points::new(points).and_then(by_method))
}
