//! Nathan's wrapping in space: for each open edge, try candidate triangles until one leaves no point outside.
//!
//! **Paper.** P. Nathan, "Obtaining the convex hull from a set of points using the gift wrapping algorithm", 2015,
//! written to sweep a moving part through a scene.
//!
//! **Essence.**
//!
//! 1. Flatten the points to the x-y plane and take one that must be on the hull of the flattened points.
//! 2. Try edges from it to the other points until one has no flattened point on its outer side: the first edge.
//! 3. Put it on a stack. While there is an edge u→v on the stack, take it off and try the triangles u v w, for w
//!    in the order of the array: test it against all points, and drop it at the first one that lies outside.
//! 4. A triangle with no point outside is a facet. Put its two new edges on the stack, *reversed*, so that the
//!    triangles to be found on them run anticlockwise too.
//!
//! ```text
//!              w                  facet           u v w
//!            /   \                new edges       v→w and w→u
//!           /     \               on the stack    w→v and u→w, for the neighbours beyond them
//!          u ----- v
//! ```
//!
//! **Bound.** Round a hull edge the candidates are ordered by angle. The one of rank r is outside the triangles of
//! r - 1 others, and on shuffled points is refuted after (n+1)/r tests on average; half of the candidates are tried
//! before the right one. That makes n (½ ln n + c) tests a search, c near 1.05 (held in `tests/space/nathan.rs`), and
//! O(h n log n) in all, not the O(n h) that the paper gives. If the points that refute come last in the array, as
//! when they are sorted from the inside out, a search takes about 0.07 n² tests, and the whole O(h n²). Space: the
//! stack and the marks, O(h).
//!
//! **Invariants.**
//!
//! 1. Every edge on the stack is an edge of the hull, directed as the facet still to be found on it has it.
//! 2. A side, that is, a directed edge, belongs to one facet only. So a facet is found once if edges whose side is
//!    taken are dropped ([`Marks::Sides`]); when all edges are marked without direction ([`Marks::Edges`]), each
//!    of the 3h - 6 edges emits a triangle, and h - 2 of those are emitted twice.
//! 3. The kernel is perturbed: points in general position, in which each edge has exactly one triangle on
//!    either side.
//!
//! **Departures.** See [`DEPARTURES`]. [`study`] takes each back by itself.
//!
//! **When not to use it.** Except to learn from: [`pivot_wrap`](mod@crate::pivot_wrap) is the same march with one
//! pass a search. At 500 points it asks four times less (six times less than the method as printed), a gap that
//! widens with ln n, and it is no longer.

mod marks;
mod options;
mod printed;
mod start;

pub use options::{Lookup, Marks, NathanOptions, OwnCorners, Start};
pub use printed::PrintedArithmetic;

use crate::surface::surface;
use geometry_core::dimension::AffineBasis;
use geometry_core::sort::merge_sort;
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points, Step};
use marks::MarkBook;

/// Where the registered method departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "the first point is the lexicographically smallest; the paper offers the largest or the smallest distance from \
     the origin, and the nearest point is on the hull by accident only",
    "an edge whose side already belongs to a triangle is dropped when it is popped; as printed, 3h-6 triangles are \
     emitted, of which h-2 are repetitions",
    "edges are marked in a hash table; the paper's list is searched from the front, O(h^2) comparisons in all",
    "a point is outside a plane exactly if it is; the paper compares rounded distances with an epsilon, which \
     vanishes for points at one distance from the z axis",
    "coplanar points are told apart by a perturbation and the triangles merged into true facets afterwards; the \
     paper takes any triangle of a flat facet, and those may overlap",
    "copies are dropped first; a triangle with two equal corners has no plane, so no point lies outside it",
    "a triangle's own corners are not tested; the paper found it quicker to test them, but they are the questions \
     that an exact filter cannot settle, and in rounded arithmetic they lie outside now and then",
];

/// The convex hull in space by Nathan's method, corrected where the paper's text does not give the hull.
///
/// # Errors
///
/// [`HullError::Contradiction`] if the triangles do not close to a surface; cannot happen with an exact kernel.
///
/// # Cost
///
/// About 2 h n (½ ln n + 1) orientations on shuffled points, O(h n²) at worst. Space O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// let cube: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let hull = gift_wrap::nathan(Points::new(&cube)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.facets().next(), Some(&[0, 1, 5, 4][..]));
/// assert_eq!((hull.len(), hull.facets().count()), (8, 6));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn nathan<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    if let Ok(flat) = AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        return Ok(flat);
    }
    let ids = distinct(points, kernel);
    let run = Wrapping::new(
        points,
        &ids,
        NathanOptions::CORRECTED,
        &Perturbed(kernel),
        observer,
    )
    .run();
    if run.ending != Ending::StackEmpty || run.barren > 0 {
        return Err(HullError::Contradiction {
            what: "an edge of the hull is an edge of no triangle that leaves all points inside",
        });
    }
    Ok(Hull3::from_mesh(points, &surface(&run.triangles)?, kernel))
}

/// The ids of the distinct points in ascending order; of copies the smallest.
fn distinct<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> Vec<u32> {
    let mut ids: Vec<u32> = points.ids().collect();
    let mut scratch = vec![0; ids.len()];
    let by_place = |a: u32, b: u32| kernel.lexicographic3(points[a], points[b]);
    merge_sort(&mut ids, &mut scratch, |a, b| {
        by_place(a, b).then(a.cmp(&b))
    });
    ids.dedup_by(|later, kept| by_place(*later, *kept).is_eq());
    ids.sort_unstable();
    ids
}

/// Runs the method with chosen parts as printed or corrected, to show what each of them does.
///
/// Whatever the points, the options and the kernel, it stops and does not panic: after 3 n triangles it gives up.
/// The kernel is a choice like the options: [`Perturbed`] for points as in general position, [`Exact`] for
/// coplanar points as they are, [`PrintedArithmetic`] for unit normals and the paper's epsilon.
///
/// # Cost
///
/// As [`nathan`]; for `Lookup::List` about 9 h² comparisons of edges more. At most 3 n³ tests, should nothing fit.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Perturbed, Points, Silent};
/// use gift_wrap::nathan::{NathanOptions, study};
/// let octahedron = [[2.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0],
///                   [0.1, 0.1, 1.0], [0.1, 0.1, -1.0]];
/// let points = Points::new(&octahedron)?;
/// let printed = study(points, NathanOptions::PRINTED, &Perturbed(Exact), &mut Silent);
/// assert_eq!((printed.triangles.len(), printed.repetitions()), (3 * 6 - 6, 6 - 2));
/// let corrected = study(points, NathanOptions::CORRECTED, &Perturbed(Exact), &mut Silent);
/// assert_eq!((corrected.triangles.len(), corrected.repetitions()), (2 * 6 - 4, 0));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
///
/// [`Exact`]: geometry_core::Exact
pub fn study<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    options: NathanOptions,
    kernel: &K,
    observer: &mut O,
) -> NathanRun {
    let ids: Vec<u32> = points.ids().collect();
    Wrapping::new(points, &ids, options, kernel, observer).run()
}

/// How a run came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// No edge was left on the stack, as the paper has it.
    StackEmpty,
    /// Step 2 found no edge from the first point: it is not on the hull of the flattened points.
    NoFirstEdge,
    /// More than 3 n triangles: they do not bound a convex surface.
    TooManyTriangles,
}

/// What a run did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NathanRun {
    /// How it ended.
    pub ending: Ending,
    /// The edge that step 2 found.
    pub first_edge: Option<[u32; 2]>,
    /// The triangles in the order they were accepted, anticlockwise seen from outside, repetitions included.
    pub triangles: Vec<[u32; 3]>,
    /// Edges for which candidates were tried.
    pub searches: u64,
    /// Edges for which no candidate was accepted.
    pub barren: u64,
    /// Tests of a flattened point against an edge, in step 2.
    pub edge_tests: u64,
    /// Tests of a point against the plane of a candidate.
    pub plane_tests: u64,
    /// Marks looked at to find out whether an edge is marked.
    pub mark_comparisons: u64,
}

impl NathanRun {
    /// How many of the triangles are repetitions of others.
    pub fn repetitions(&self) -> usize {
        let from_smallest = |&corners: &[u32; 3]| {
            let mut corners = corners;
            let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(first);
            corners
        };
        let mut distinct: Vec<[u32; 3]> = self.triangles.iter().map(from_smallest).collect();
        distinct.sort_unstable();
        distinct.dedup();
        self.triangles.len() - distinct.len()
    }
}

/// The state of a run over the points `ids`.
struct Wrapping<'a, K, O> {
    points: Points<'a, 3>,
    ids: &'a [u32],
    options: NathanOptions,
    kernel: &'a K,
    observer: &'a mut O,
    stack: Vec<[u32; 2]>,
    marks: MarkBook,
    run: NathanRun,
}

impl<'a, K: Kernel3, O: Observer> Wrapping<'a, K, O> {
    fn new(
        points: Points<'a, 3>,
        ids: &'a [u32],
        options: NathanOptions,
        kernel: &'a K,
        observer: &'a mut O,
    ) -> Self {
        Self {
            points,
            ids,
            options,
            kernel,
            observer,
            stack: Vec::new(),
            marks: MarkBook::new(options.marks, options.lookup),
            run: NathanRun {
                ending: Ending::StackEmpty,
                first_edge: None,
                triangles: Vec::new(),
                searches: 0,
                barren: 0,
                edge_tests: 0,
                plane_tests: 0,
                mark_comparisons: 0,
            },
        }
    }

    fn run(mut self) -> NathanRun {
        self.run.ending = self.wrap();
        self.run.mark_comparisons = self.marks.comparisons();
        self.run
    }

    /// Steps 1 to 4.
    fn wrap(&mut self) -> Ending {
        self.run.first_edge = self.first_point().and_then(|first| self.first_edge(first));
        let Some(edge) = self.run.first_edge else {
            return Ending::NoFirstEdge;
        };
        self.observer.step(|| Step::Edge(edge[0], edge[1]));
        self.stack.push(edge);
        self.marks.add_pushed(edge);
        while let Some(edge) = self.stack.pop() {
            if self.marks.is_side_taken(edge) {
                continue;
            }
            let Some(apex) = self.apex(edge) else {
                self.run.barren += 1;
                continue;
            };
            if self.run.triangles.len() >= 3 * self.ids.len() {
                return Ending::TooManyTriangles;
            }
            self.accept(edge, apex);
        }
        Ending::StackEmpty
    }

    /// The first point in the order of the array whose triangle with `edge` leaves no point outside.
    fn apex(&mut self, edge: [u32; 2]) -> Option<u32> {
        self.run.searches += 1;
        self.observer.step(|| Step::Line(edge[0], edge[1]));
        let candidates = self.ids.iter().copied();
        candidates
            .filter(|id| !edge.contains(id))
            .find(|&id| self.leaves_all_inside([edge[0], edge[1], id]))
    }

    fn leaves_all_inside(&mut self, corners: [u32; 3]) -> bool {
        self.observer.step(|| Step::Candidate(corners[2]));
        let [u, v, w] = corners.map(|id| self.points[id]);
        for &id in self.ids {
            if self.options.own_corners == OwnCorners::Skipped && corners.contains(&id) {
                continue;
            }
            self.run.plane_tests += 1;
            if self.kernel.orient3(u, v, w, self.points[id]).is_positive() {
                return false;
            }
        }
        true
    }

    /// Step 4.
    fn accept(&mut self, [u, v]: [u32; 2], w: u32) {
        self.run.triangles.push([u, v, w]);
        self.observer.step(|| Step::Facet(u, v, w));
        self.marks.add_sides([[u, v], [v, w], [w, u]]);
        for reversed in [[w, v], [u, w]] {
            if !self.marks.is_marked(reversed) {
                self.stack.push(reversed);
                self.marks.add_pushed(reversed);
            }
        }
    }
}
