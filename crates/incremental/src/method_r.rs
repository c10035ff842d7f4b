//! Method R: the hull of the points so far, mended as each point is added.
//!
//! **Source.** P. J. Green and B. W. Silverman, "Constructing the convex hull of a set of points in the plane",
//! *The Computer Journal* 22(3), 262–266, 1979, section 5, where it is one of the seven methods compared; the
//! paper names no inventor.
//!
//! **Essence.**
//!
//! 1. The first three points form their own hull.
//! 2. Each further point is tested against every edge of the hull so far.
//! 3. If it lies outside none, nothing changes. Otherwise the edges it lies outside of are deleted and two edges
//!    to the new point replace them.
//!
//! ```text
//!                 p                              p
//!                                              .' '.
//!         d-------c         outside: bc, cd   /     \
//!        /         \                         d       \
//!       /           b       deleted: c      /         b
//!      e           /                       e         /
//!       '--...--- a                         '--...--a
//! ```
//!
//! **Bound.** The i-th point costs one orientation for each of the h_{i-1} edges of the hull of those before
//! it: Σ h_{i-1} in all, at most n h when the hull only grows, and O(n²) at worst. Space: the hull and one
//! flag an edge.
//!
//! **Invariants.**
//!
//! 1. Before point i is added, the list holds the hull of the points before it, anticlockwise, under the chosen
//!    boundary convention.
//! 2. The edges a point lies outside of follow one another without a gap, and are never all of them.
//! 3. Points arrive in order of index, so of equal points the one with the smallest index is already there when
//!    the others come, and they change nothing.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When the hull is large: the scan of all edges spends h tests on each interior point. It
//! earns its place when points arrive one by one and h is small, as for 1,000 points of the Cauchy
//! distribution in the source's Table 2, where it beats Graham's.

use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Sign, Step};
use std::cmp::Ordering;

/// Where this file departs from the source, and why.
pub const DEPARTURES: &[&str] = &[
    "the source starts from three points that form a triangle; here the first points may be equal or collinear, \
     and are set aside until one leaves their line",
    "the source leaves open what a point on the line of an edge does; here the kernel tells, and the convention \
     for boundary points decides, so that the result is right for every input",
];

/// The convex hull by adding one point at a time, in the order given.
///
/// # Errors
///
/// [`HullError::Contradiction`] if the edges outside of which a point lies are not one run of the hull; cannot
/// happen with an exact kernel.
///
/// # Cost
///
/// h orientations a point, where h is the size of the hull of the points before it: O(n h) for a hull that
/// only grows. A start of m collinear points costs O(m log m) comparisons. Space O(h + m).
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Counted, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0], [2.0, 2.0]];
/// let kernel = Counted::new(Exact);
/// let hull = incremental::method_r(Points::new(&points)?, Boundary::Extreme, &kernel, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 3]);
/// // One for the first triangle, three for each of the two points after it.
/// assert_eq!(kernel.counts().orientations.total(), 1 + 3 + 3);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn method_r<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let mut rest = points.ids();
    let mut hull = match first_polygon(points, boundary, kernel, observer, &mut rest) {
        Start::Collinear(hull) => return Ok(hull),
        Start::Polygon(vertices) => GrowingHull {
            points,
            boundary,
            kernel,
            vertices,
            outside: Vec::new(),
        },
    };
    for id in rest {
        observer.step(|| Step::Visit(id));
        if hull.test_edges(id, observer) {
            let run = hull.outside_run()?;
            hull.replace(run, id, observer);
        } else {
            observer.step(|| Step::Discard(id));
        }
    }
    Ok(hull.finish(observer))
}

/// How the first points lie.
enum Start {
    /// There is nothing but collinear points: this is their hull.
    Collinear(Hull2),
    /// The first points that are not all collinear form this hull.
    Polygon(Vec<u32>),
}

/// Takes points from `rest` up to and including the first that is not collinear with those before it.
fn first_polygon<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
    rest: &mut std::ops::Range<u32>,
) -> Start {
    let collinear = |row| Hull2::of_collinear(points, row, boundary, kernel);
    let mut row: Vec<u32> = Vec::new();
    let mut line: Option<(u32, u32)> = None;
    for id in rest {
        observer.step(|| Step::Visit(id));
        if let Some((from, to)) = line {
            let side = kernel.orient(points[from], points[to], points[id]);
            if !side.is_zero() {
                // Along the line, from the end that leaves the new point on the left.
                let mut vertices = collinear(row).vertices().to_vec();
                let ascending = kernel.lexicographic(points[from], points[to]) == Ordering::Less;
                if ascending != side.is_positive() {
                    vertices.reverse();
                }
                vertices.push(id);
                observer.step(|| Step::Insert(id));
                return Start::Polygon(vertices);
            }
        } else if let Some(&first) = row.first()
            && kernel.lexicographic(points[first], points[id]) != Ordering::Equal
        {
            line = Some((first, id));
        }
        row.push(id);
    }
    Start::Collinear(collinear(row))
}

/// The hull of the points added so far (invariant 1).
struct GrowingHull<'a, K> {
    points: Points<'a, 2>,
    boundary: Boundary,
    kernel: &'a K,
    /// Anticlockwise; edge i leads from vertex i to the next.
    vertices: Vec<u32>,
    /// For each edge, whether the latest point lies outside it.
    outside: Vec<bool>,
}

/// A run of consecutive edges, cyclic: `length` of them from edge `first`.
struct Run {
    first: usize,
    length: usize,
}

impl<K: Kernel2> GrowingHull<'_, K> {
    /// Tests `id` against every edge; tells whether it lies outside any.
    fn test_edges<O: Observer>(&mut self, id: u32, observer: &mut O) -> bool {
        let mut outside = std::mem::take(&mut self.outside);
        outside.clear();
        outside.extend(self.edges().map(|(from, to)| {
            observer.step(|| Step::Line(from, to));
            self.is_outside(from, to, id)
        }));
        self.outside = outside;
        self.outside.contains(&true)
    }

    fn edges(&self) -> impl Iterator<Item = (u32, u32)> {
        let starts = self.vertices.iter().copied();
        let ends = self.vertices[1..].iter().chain(self.vertices.first());
        starts.zip(ends.copied())
    }

    /// Whether `id` makes the edge obsolete: it lies to the right of it, or on its line and
    ///
    /// - under [`Boundary::Extreme`] beyond an end, which is then no corner any more;
    /// - under [`Boundary::All`] between the ends, and becomes a vertex there.
    fn is_outside(&self, from: u32, to: u32, id: u32) -> bool {
        let [a, b, p] = [from, to, id].map(|id| self.points[id]);
        match self.kernel.orient(a, b, p) {
            Sign::Negative => true,
            Sign::Positive => false,
            Sign::Zero => {
                let after_start = self.kernel.compare_along(a, b, a, p);
                let before_end = self.kernel.compare_along(a, b, p, b);
                match self.boundary {
                    Boundary::Extreme => {
                        after_start == Ordering::Greater || before_end == Ordering::Greater
                    }
                    Boundary::All => after_start == Ordering::Less && before_end == Ordering::Less,
                }
            }
        }
    }

    /// The run of edges marked `outside` (invariant 2).
    fn outside_run(&self) -> Result<Run, HullError> {
        let count = self.outside.len();
        let mut starts = (0..count)
            .filter(|&edge| self.outside[edge] && !self.outside[(edge + count - 1) % count]);
        match (starts.next(), starts.next()) {
            (Some(first), None) => Ok(Run {
                first,
                length: self.outside.iter().filter(|&&outside| outside).count(),
            }),
            _ => Err(HullError::Contradiction {
                what: "the edges that a new point lies outside of are not one run of the hull",
            }),
        }
    }

    /// Deletes the edges of `run` and puts two edges to `id` in their place.
    fn replace<O: Observer>(&mut self, run: Run, id: u32, observer: &mut O) {
        self.vertices.rotate_left(run.first);
        for passed in self.vertices.splice(1..run.length, [id]) {
            observer.step(|| Step::Pop(passed));
        }
        observer.step(|| Step::Insert(id));
    }

    fn finish<O: Observer>(self, observer: &mut O) -> Hull2 {
        for (from, to) in self.edges() {
            observer.step(|| Step::Edge(from, to));
        }
        Hull2::from_cycle(self.points, self.vertices)
    }
}
