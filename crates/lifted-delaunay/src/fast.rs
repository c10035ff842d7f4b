//! Delaunay triangulations by divide and conquer.
//!
//! **Source.** L. Guibas and J. Stolfi, "Primitives for the manipulation of general subdivisions and the computation of
//! Voronoi diagrams", *ACM Transactions on Graphics* 4(2), 74–123, 1985. R. A. Dwyer, "A faster divide-and-conquer
//! algorithm for constructing Delaunay triangulations", *Algorithmica* 2, 137–151, 1987, divides across both axes, so that
//! parts are compact and few edges of one are undone by its neighbours. J. R. Shewchuk, "Triangle", 1996, keeps triangles and
//! ghosts instead of edges, and shows how far plain arrays carry it.
//!
//! **Essence.**
//!
//! 1. Sort the points into the cells of a grid, numbered so that every aligned run of 2ᵏ cells is a box (`grid`). Divide
//!    a cell of more than three points at the middle of its longer side, and so on (`halving`).
//! 2. Triangulate two or three points at once (`few`).
//! 3. Join the triangulations of the two halves of a box along the line between them, from the bottom up (`merge`), and
//!    so on up to the whole.
//! 4. Write down the triangles in the memory of the sites, and sort them by counting in that of the faces.
//!
//! **Exactness.** All signs are those of the exact kernel. Questions of a merge are about points of one box, and the smaller the
//! box the tighter is its filter, computed once ([`Boxed`](geometry_core::exact::Boxed)); on a lattice even zeros
//! are certain at once. Where four points are on a circle, a rule decides (`tie`).
//!
//! **Bound.** O(n log n) time for points that spread over the grid, O(n log² n) at worst; the merges take expected O(n) if
//! points are uniform. About 7.2 in-circle questions a point and 6.8 orientations, at any n.
//!
//! **Invariants.**
//!
//! 1. The two halves of a set are strictly separated in x or in y, so merges may tilt the line between them as they
//!    like, and copies of a point stay together until nothing else is left: then the smallest index stands for all.
//! 2. A part is the Delaunay triangulation of its points, by the rule for ties.
//! 3. The extremes of a part are known, each with the ghost of the edge of the hull that leaves it anticlockwise (`part`), so
//!    either axis can be the next to be merged across.
//! 4. The depth of the recursion is O(log² n): a box of which one cell holds more than half of the points is divided at
//!    the median instead.
//!
//! **Threads.** [`fast_delaunay_parallel`] conquers halves side by side.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When points come one by one, or edges are prescribed.

mod asking;
mod faces;
mod few;
mod grid;
mod halving;
mod merge;
mod parallel;
mod part;
mod site;
mod tie;

pub use parallel::fast_delaunay_parallel;

use asking::{Asking, Filtered, Tallied};
use faces::{EDGES_PER_FACE, FACES_PER_VERTEX, Faces, NONE, TRIPLES_PER_VERTEX, Triple};
use geometry_core::{HullError, Points, QuestionCounts, Triangulation};
use grid::Grid;
use halving::Extent;
use part::{Across, Part};
use site::{Site, Sited, room_for_triangles};
use std::ops::Range;

/// Where the method departs from Guibas and Stolfi, and from Dwyer, and why.
pub const DEPARTURES: &[&str] = &[
    "sets are halved across their longer side, where they are large by a grid, instead of into rows of cells",
    "the extremes of a part are kept with their ghosts, so that parts join across either axis without a search",
    "triangles and ghosts are kept, not edges and their duals; an edge is removed by flipping it",
    "of points on one circle the lexicographically first is joined to all others",
];

/// Where the method on several processors departs from the sequential one.
pub const PARALLEL_DEPARTURES: &[&str] = &[
    "the parts of the first halvings are triangulated side by side, and the triangles are read off in shares",
    "otherwise as fast-delaunay",
];

/// Sets of up to so many sites are halved without a grid.
const FEW: usize = 512;

/// The average number of sites in a cell of a grid.
const CELL: usize = 8;

/// The Delaunay triangulation of `points`.
///
/// Exact for every finite input, and equal to that of every other method: where more than three points lie on one
/// circle, their polygon is cut into the fan from its lexicographically smallest corner. Of copies of a point the
/// smallest index stands for all; points that are all collinear have no triangles.
///
/// # Errors
///
/// [`HullError::TooManyPoints`] from 536 million points on: edges could not be numbered any more.
///
/// # Cost
///
/// O(n log n) time, see [the module](self); about 80 n bytes at its peak, the result included.
///
/// ```
/// use geometry_core::Points;
/// let kite = [[0.0, 0.0], [1.0, -1.0], [4.0, 0.0], [1.0, 1.0]];
/// let triangulation = lifted_delaunay::fast_delaunay(Points::new(&kite)?)?;
/// assert_eq!(triangulation.triangles(), [[0, 1, 3], [1, 2, 3]]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_delaunay(points: Points<'_, 2>) -> Result<Triangulation, HullError> {
    triangulate(points, &mut Filtered::new(points))
}

/// [`fast_delaunay`], and what it asked.
///
/// # Errors
///
/// As [`fast_delaunay`].
///
/// # Cost
///
/// As [`fast_delaunay`], and the counting.
///
/// ```
/// use geometry_core::Points;
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let (triangulation, asked) = lifted_delaunay::fast_delaunay_counted(Points::new(&square)?)?;
/// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// assert!(asked.in_circles.total() > 0);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_delaunay_counted(
    points: Points<'_, 2>,
) -> Result<(Triangulation, QuestionCounts), HullError> {
    let mut tallied = Tallied {
        filtered: Filtered::new(points),
        counts: QuestionCounts::default(),
    };
    let triangulation = triangulate(points, &mut tallied)?;
    Ok((triangulation, tallied.counts))
}

fn triangulate<A: Asking>(
    points: Points<'_, 2>,
    asking: &mut A,
) -> Result<Triangulation, HullError> {
    let mut triples = room_for_faces(points)?;
    let mut sites = vec![Site::default(); points.len()];
    let extent = Extent::of(points.as_slice().iter().copied());
    let grid = Grid::sort(named(points), &extent, CELL, &mut sites);
    let mut conquest = Conquest {
        sites: &mut sites,
        faces: Faces::new(&mut triples),
        asking,
    };
    conquest.solve_cells(&grid, 0, 0..grid.len(), 0);
    let names: Vec<u32> = conquest.sites.iter().map(Sited::id).collect();
    let faces = conquest.faces;
    let room = room_for_triangles(conquest.sites);
    let found = faces.triangles(0..faces.len(), &names, room);
    let triangles = &mut room_for_triangles(&mut sites)[..found];
    Ok(Triangulation::in_room(triangles, triples))
}

/// Zeros for the faces of `points`.
fn room_for_faces(points: Points<'_, 2>) -> Result<Vec<Triple>, HullError> {
    let count = points.len();
    if count >= (NONE / EDGES_PER_FACE) as usize / FACES_PER_VERTEX {
        return Err(HullError::TooManyPoints { count });
    }
    Ok(vec![Triple::default(); TRIPLES_PER_VERTEX * count])
}

/// The sites of `points`, in their order.
fn named(points: Points<'_, 2>) -> impl Iterator<Item = Site> + Clone {
    let named = points.as_slice().iter().zip(points.ids());
    named.map(|(&at, id)| Site::new(at, id))
}

/// The sites, partly divided, and the faces so far.
struct Conquest<'a, A> {
    sites: &'a mut [Site],
    faces: Faces<'a>,
    asking: &'a mut A,
}

impl<A: Asking> Conquest<'_, A> {
    /// Triangulates the sites from `from` up to `to`.
    fn solve(&mut self, from: usize, to: usize) -> Option<Part> {
        let sites = &mut self.sites[from..to];
        let first = from as u32;
        match sites.len() {
            0 => return None,
            1 => return Some(Part::point(first)),
            _ => {}
        }
        let extent = Extent::of(sites.iter().map(Sited::at));
        if extent.is_point() {
            let least = (0..sites.len()).min_by_key(|&i| sites[i].id()).unwrap_or(0);
            sites.swap(0, least);
            return Some(Part::point(first));
        }
        match sites {
            [_, _] => {
                return Some(few::edge(self.sites, &mut self.faces, first));
            }
            [a, b, c] if a.at() != b.at() && b.at() != c.at() && c.at() != a.at() => {
                return Some(self.triangle(first, &extent));
            }
            _ => {}
        }
        let (half, across) = if sites.len() <= FEW {
            halving::halve(sites, &extent)
        } else {
            let unsorted = sites.to_vec();
            let grid = Grid::sort(unsorted.iter().copied(), &extent, CELL, sites);
            if grid.most() as usize <= sites.len() / 2 {
                return self.solve_cells(&grid, from, 0..grid.len(), 0);
            }
            halving::halve_at_median(sites, &extent)
        };
        let left = self.solve(from, from + half);
        let right = self.solve(from + half, to);
        self.join(left, right, from + half, across)
    }

    /// Triangulates the sites of cells that make up a box, at a level of the grid whose sites begin at `from`.
    fn solve_cells(
        &mut self,
        grid: &Grid,
        from: usize,
        cells: Range<usize>,
        level: usize,
    ) -> Option<Part> {
        let [start, end] = [cells.start, cells.end].map(|cell| grid.starts[cell] as usize);
        if cells.len() == 1 || end - start <= 3 {
            return self.solve(from + start, from + end);
        }
        let middle = cells.start + cells.len() / 2;
        let left = self.solve_cells(grid, from, cells.start..middle, level + 1);
        let right = self.solve_cells(grid, from, middle..cells.end, level + 1);
        let middle = from + grid.starts[middle] as usize;
        self.join(left, right, middle, grid.levels[level])
    }

    fn triangle(&mut self, first: u32, extent: &Extent) -> Part {
        let [width, height] = extent.sides();
        let kernel = self.asking.in_box(width, height);
        let part = few::triangle(self.sites, &mut self.faces, &kernel, first);
        self.asking.done(kernel);
        part
    }

    /// Joins two parts, the sites of the second of which begin at `middle`.
    fn join(
        &mut self,
        left: Option<Part>,
        right: Option<Part>,
        middle: usize,
        across: Across,
    ) -> Option<Part> {
        let (Some(left), Some(right)) = (left, right) else {
            return left.or(right);
        };
        let halves = [&left, &right];
        let (faces, asking) = (&mut self.faces, &mut *self.asking);
        Some(merge::merge(
            self.sites, faces, asking, halves, middle, across,
        ))
    }
}
