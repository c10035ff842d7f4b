//! Preparata and Hong's planar hull: sort, halve, and join the hulls of the halves by two supporting lines.
//!
//! **Paper.** F. P. Preparata and S. J. Hong, "Convex hulls of finite sets of points in two and three
//! dimensions", *Communications of the ACM* 20(2), 87–93, 1977, the planar algorithm.
//!
//! **Essence.**
//!
//! 1. Sort the points from left to right and split them in two halves of equal size.
//! 2. Find the hull of each half in the same way; one point is its own hull.
//! 3. The two hulls are side by side. Start from the segment between their facing ends, the rightmost vertex a of
//!    the left hull and the leftmost vertex b of the right one. While the neighbour of a or of b lies below
//!    the line ab, step to it. What remains is the lower supporting line; the upper one is found alike.
//! 4. What the walks passed lies inside; the rest, joined by the two lines, is the hull.
//!
//! ```text
//!          .---------______                        start      a0 b0
//!         /               '''--.                   a0 -> a1   a1 lies below a0 b0
//!        /   A    a0   b0   B   \                  b0 -> b1   b1 lies below a1 b0
//!       .         /     \        .                 b1 -> b2   b2 lies below a1 b1
//!        \     a1/       \b1     |                 a1 -> a2   a2 lies below a1 b2
//!         \   .'          '.    .'                 stop       neither neighbour lies below a2 b2
//!          '.a2              b2'
//!            '----------------'   lower supporting line
//! ```
//!
//! **Bound.** The sort, O(n log n), and at most 8 n orientations for all merges together. A test after which the walk
//! steps on deletes a vertex from a chain for good (invariant 3): at most 2 n. A test after which an end stands is
//! the first on its side for this line, or follows a step on the other side: at most 2 n again, and two for
//! each of the 2 (n-1) lines. On points in a disc it is about 4 n. Recursion is ⌈log₂ n⌉ deep. Space: the
//! sorted list and four links a point.
//!
//! **Storage.** Linked lists over the places in the sorted order, not slices: a merge then relinks two ends and
//! touches only what it deletes, while copying slices would cost every level of the recursion O(n). A hull is
//! held as two chains from its leftmost to its rightmost vertex, a lower and an upper one, because a ring
//! cannot hold a row of collinear points, where each inner point would follow two others. The walk for a
//! supporting line stays on one chain in any case.
//!
//! **Invariants.**
//!
//! 1. After a range of the sorted order is conquered, both its chains run from its first to its last place, and
//!    are the lower and the upper hull of its points under the chosen boundary convention.
//! 2. Ranges are separated in the order by x, then y: as if the plane were sheared by an infinitesimal, so that
//!    no two distinct points are one above the other, and a split through a vertical column is like any other.
//! 3. A place passed by a walk is never reached again.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** In the plane, a sort and one scan (`monotone-chain`) need about as many orientations and
//! less storage. This method is here because it is the one that carries over to space, and to several processors.

use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Sign, Step};
use std::ops::Range;

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "points of equal x, which the paper leaves aside, are ordered by y, so that every split separates; copies \
     are dropped after the sort",
    "slopes are not computed: whether a vertex lies below the line between two others is an orientation",
    "a hull is held as a lower and an upper chain instead of one ring, so that rows of collinear points need no \
     special case",
];

/// The convex hull by Preparata and Hong's divide and conquer.
///
/// # Errors
///
/// [`HullError::Contradiction`] if a point comes out both below and above the others; cannot happen with an
/// exact kernel.
///
/// # Cost
///
/// O(n log n) lexicographic comparisons and at most 8 n orientations. Space: 5 n indices.
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Exact, Hull2, Points, Silent};
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 3.0], [1.0, 1.0]];
/// let points = Points::new(&points)?;
/// let hull = |boundary| divide_and_conquer::preparata_hong_2d(points, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?, Hull2::Polygon(vec![0, 2, 3]));
/// assert_eq!(hull(Boundary::All)?, Hull2::Polygon(vec![0, 1, 2, 3]));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn preparata_hong_2d<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let mut sorted: Vec<u32> = points.ids().collect();
    sort_distinct(points, &mut sorted, kernel);
    let mut conquest = Conquest {
        points,
        boundary,
        kernel,
        observer,
        lower: Chain::of_single_points(sorted.len()),
        upper: Chain::of_single_points(sorted.len()),
        sorted,
    };
    conquest.conquer(0..conquest.sorted.len());
    conquest.into_hull()
}

/// The links of one chain over places in the sorted order. The ends of a chain link to themselves.
struct Chain {
    before: Vec<u32>,
    after: Vec<u32>,
}

impl Chain {
    fn of_single_points(count: usize) -> Self {
        let itself: Vec<u32> = (0..count as u32).collect();
        Self {
            before: itself.clone(),
            after: itself,
        }
    }

    fn before(&self, place: usize) -> usize {
        self.before[place] as usize
    }

    fn after(&self, place: usize) -> usize {
        self.after[place] as usize
    }

    fn link(&mut self, place: usize, next: usize) {
        self.after[place] = next as u32;
        self.before[next] = place as u32;
    }

    /// The places on the chain from `first` to its end.
    fn walk(&self, first: usize) -> Vec<usize> {
        let following = |&place: &usize| Some(self.after(place)).filter(|&next| next != place);
        std::iter::successors(Some(first), following).collect()
    }
}

/// Which of the two chains of a hull.
#[derive(Clone, Copy)]
enum Side {
    Lower,
    Upper,
}

struct Conquest<'a, K, O> {
    points: Points<'a, 2>,
    boundary: Boundary,
    kernel: &'a K,
    observer: &'a mut O,
    /// The distinct points from left to right; the chains link places in this list.
    sorted: Vec<u32>,
    lower: Chain,
    upper: Chain,
}

impl<K: Kernel2, O: Observer> Conquest<'_, K, O> {
    /// Establishes invariant 1 for `range`.
    fn conquer(&mut self, range: Range<usize>) {
        if range.len() < 2 {
            return;
        }
        let middle = range.start + range.len() / 2;
        self.conquer(range.start..middle);
        self.conquer(middle..range.end);
        let vertices = if O::ACTIVE {
            self.size(range.start) + self.size(middle)
        } else {
            0
        };
        self.bridge(Side::Lower, middle);
        self.bridge(Side::Upper, middle);
        self.observer.step(|| Step::Merge(vertices as u32));
    }

    /// Joins the chains of the halves that end before `middle` and start at it by their supporting line.
    fn bridge(&mut self, side: Side, middle: usize) {
        let (mut left, mut right) = (middle - 1, middle);
        self.examine(left, right);
        // An end stands until the other one moves.
        let (mut left_stands, mut right_stands) = (false, false);
        while !(left_stands && right_stands) {
            if left_stands {
                let next = self.chain(side).after(right);
                right_stands = next == right || self.stands(side, [left, right, next]);
                if !right_stands {
                    self.pass(right);
                    (right, left_stands) = (next, false);
                    self.examine(left, right);
                }
            } else {
                let next = self.chain(side).before(left);
                left_stands = next == left || self.stands(side, [next, left, right]);
                if !left_stands {
                    self.pass(left);
                    (left, right_stands) = (next, false);
                    self.examine(left, right);
                }
            }
        }
        let (from, to) = (self.sorted[left], self.sorted[right]);
        self.observer.step(|| Step::Bridge(from, to));
        match side {
            Side::Lower => self.lower.link(left, right),
            Side::Upper => self.upper.link(left, right),
        }
    }

    fn chain(&self, side: Side) -> &Chain {
        match side {
            Side::Lower => &self.lower,
            Side::Upper => &self.upper,
        }
    }

    /// Whether the middle one of three places in order belongs on the chain: it lies outside the line through
    /// the others, or on it if boundary points count.
    fn stands(&self, side: Side, places: [usize; 3]) -> bool {
        let [a, b, c] = places.map(|place| self.points[self.sorted[place]]);
        let turn = self.kernel.orient(a, b, c);
        let outward = match side {
            Side::Lower => turn,
            Side::Upper => -turn,
        };
        match self.boundary {
            Boundary::Extreme => outward == Sign::Positive,
            Boundary::All => outward != Sign::Negative,
        }
    }

    fn examine(&mut self, left: usize, right: usize) {
        let (from, to) = (self.sorted[left], self.sorted[right]);
        self.observer.step(|| Step::Line(from, to));
    }

    fn pass(&mut self, place: usize) {
        let id = self.sorted[place];
        self.observer.step(|| Step::Pop(id));
    }

    /// The lower and the upper chain of the hull that begins at place `first`.
    fn chains(&self, first: usize) -> [Vec<usize>; 2] {
        [&self.lower, &self.upper].map(|chain| chain.walk(first))
    }

    /// How many vertices that hull has.
    fn size(&self, first: usize) -> usize {
        let [lower, upper] = self.chains(first);
        if lower == upper {
            lower.len()
        } else {
            lower.len() + upper.len() - 2
        }
    }

    /// The hull of all points, once they are conquered.
    fn into_hull(self) -> Result<Hull2, HullError> {
        let count = self.sorted.len();
        if count < 2 {
            return Ok(Hull2::from_cycle(self.points, self.sorted));
        }
        let [lower, upper] = self.chains(0);
        let ids = |places: &[usize]| -> Vec<u32> {
            places.iter().map(|&place| self.sorted[place]).collect()
        };
        if lower == upper {
            return Ok(Hull2::of_collinear(
                self.points,
                ids(&lower),
                self.boundary,
                self.kernel,
            ));
        }
        let inner = &upper[1..upper.len() - 1];
        if inner.iter().any(|place| lower.binary_search(place).is_ok()) {
            return Err(HullError::Contradiction {
                what: "a vertex of both the lower and the upper hull of points that are not collinear",
            });
        }
        let mut cycle = ids(&lower);
        cycle.extend(ids(inner).iter().rev());
        Ok(Hull2::from_cycle(self.points, cycle))
    }
}
