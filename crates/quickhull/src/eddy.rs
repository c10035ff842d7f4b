//! Eddy's algorithm CONVEX, with its subroutine SPLIT: method E of Green and Silverman's comparison.
//!
//! **Paper.** W. F. Eddy, "A new convex hull algorithm for planar sets", *ACM Transactions on Mathematical
//! Software* 3(4), 398–403, 1977, and "Algorithm 523: CONVEX", 411–412.
//!
//! **Essence.**
//!
//! 1. The points with the smallest and the largest x are vertices. SPLIT all others by the line through them into
//!    the points above and the points below, and find the furthest on each side.
//! 2. The furthest point k above a directed edge ij is a vertex: put it between i and j in the linked list. SPLIT
//!    the points above ij by the line ik. Those above it are the *left son*, taken up next; the others are laid
//!    aside as the *right son*.
//! 3. When an edge has nothing above it, it is confirmed. Take back the right son laid aside last, which belongs
//!    to the next edge kj, and SPLIT it by that edge. Those above it are taken up as in step 2; the others lie in
//!    the triangle ijk and are dropped.
//! 4. When no right son is left, do the same with the points below the first line.
//!
//! ```text
//!                     k                    the binary tree of subsets
//!                   .' '.
//!                 .'     '.    left             above ij
//!         .     .'         '.   son            /        \
//!             .'  .     .    '.  .       above ik     not above ik, laid aside
//!           .'     .   .     . '.       (left son)    (right son)
//!         j ---------------------- i                  /         \
//!          right son: all this, and               above kj    in the triangle,
//!          what is above kj                                      dropped
//! ```
//!
//! **How it differs from method GS.** Both grow the same tree and ask about the same orientations (of points in
//! general position; they may break ties apart). Their passes are organised differently:
//!
//! - GS splits a list by both new lines in one pass and drops the triangle's points there and then. CONVEX goes
//!   down its tree depth first, one line a pass: what is not above ik is laid aside with the triangle's points
//!   still in it, and a second SPLIT drops them when the walk along the hull comes to kj.
//! - SPLIT finds the furthest point on every side that it saves. For a right son that is wasted, as its own
//!   SPLIT finds the furthest above kj afresh. So E compares more distances: 1.8 times as many as GS on points
//!   in a disc.
//! - GS keeps its test lists at both ends of one array and reads the hull off a stack. CONVEX has two arrays, for
//!   left and for right sons, and a linked list (IH, IL) of the vertices, kept in the order of their discovery.
//!
//! **Bound.** O(n h), reached when each split sets one point apart; 3 to 4 orientations a point on the usual
//! distributions. Space: the arrays IA and IB, up to 2 n indices; the list; and a record for each right son laid
//! aside, at most h. No recursion.
//!
//! **Invariants.**
//!
//! 1. `current` holds exactly the points above the edge taken up that may still be vertices. The right sons laid
//!    aside lie one behind the other at the end of `aside`, that of the nearest edge last.
//! 2. Each vertex in the list is a corner of the hull, or a boundary point on a confirmed edge: the apex of a
//!    split is the furthest point, and of several equally far the last along the edge.
//! 3. Every apex leaves its subset, and every right son is taken back once, so the work ends whatever the kernel
//!    answers.
//! 4. A point on the line of an edge, between its ends, is a boundary point exactly if nothing is above the edge.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When splits may be lopsided, as for points with exponentially growing coordinates:
//! quadratic. `gs` has the same bound with less work.

use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Sign, Step};
use std::cmp::Ordering;

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "the paper makes no attempt at degeneracies: above and furthest are told by rounded vertical distances. Here the \
     kernel is asked, of points equally far the one that is a corner is taken, and points on an edge are \
     kept if boundary points count",
    "the points with extreme x are taken lexicographically, which settles several with the same x and vertical \
     lines alike",
    "one procedure serves both halves: an orientation knows the direction of an edge, so below needs no mirror \
     image of above",
    "the edge of a right son is kept beside its count instead of being found again by walking the list",
];

/// The convex hull by Eddy's CONVEX.
///
/// # Errors
///
/// None of its own: with a kernel that contradicts itself it gives some polygon of distinct points.
///
/// # Cost
///
/// O(n h) orientations and distance comparisons, about linear on average for the usual distributions. Space:
/// O(n) indices.
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Counted, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0], [2.0, 2.0]];
/// let kernel = Counted::new(Exact);
/// let hull = quickhull::eddy(Points::new(&points)?, Boundary::Extreme, &kernel, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 3]);
/// // Three points against the first line, then two against each of the two edges above it.
/// assert_eq!(kernel.counts().orientations.total(), 3 + 2 + 2);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn eddy<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let Some((left, right)) = extremes(points, kernel) else {
        return Ok(Hull2::Empty);
    };
    if left == right {
        return Ok(Hull2::Point(left));
    }
    let mut above: Vec<u32> = points
        .ids()
        .filter(|&id| id != left && id != right)
        .collect();
    let mut below = Vec::new();
    let mut convex = Convex::between(right, left, points, boundary, kernel, observer);
    let root = convex.split((right, left), &mut above, Below::Save(&mut below));
    let mut on_line = std::mem::take(&mut convex.on_line);
    if root.above.is_none() && root.below.is_none() {
        on_line.extend([left, right]);
        return Ok(Hull2::of_collinear(points, on_line, boundary, kernel));
    }
    convex.start_half(root.above, &mut on_line);
    convex.half(FIRST, root.above, &mut above, &mut below);
    convex.start_half(root.below, &mut on_line);
    convex.half(SECOND, root.below, &mut below, &mut above);
    Ok(convex.into_hull())
}

/// The lexicographically smallest and largest points, of copies those with the smallest index.
fn extremes<K: Kernel2>(points: Points<'_, 2>, kernel: &K) -> Option<(u32, u32)> {
    let first = points.ids().next()?;
    let (mut left, mut right) = (first, first);
    for id in points.ids().skip(1) {
        if kernel.lexicographic(points[id], points[left]) == Ordering::Less {
            left = id;
        } else if kernel.lexicographic(points[id], points[right]) == Ordering::Greater {
            right = id;
        }
    }
    Some((left, right))
}

/// What SPLIT does with the points below its line.
enum Below<'v> {
    /// Puts them at the end of this list.
    Save(&'v mut Vec<u32>),
    /// Drops them: they lie in a triangle of vertices.
    Drop,
}

/// The places of the furthest points in the lists of those above and those below.
#[derive(Default)]
struct Furthest {
    above: Option<usize>,
    below: Option<usize>,
}

/// A subset laid aside: the last `count` points of its list, to be split by the edge that starts at `slot`.
struct RightSon {
    slot: usize,
    count: usize,
}

/// The list slots of the two vertices that the algorithm starts with.
const FIRST: usize = 0;
const SECOND: usize = 1;

struct Convex<'a, K, O> {
    points: Points<'a, 2>,
    boundary: Boundary,
    kernel: &'a K,
    observer: &'a mut O,
    /// IH: the vertices in the order they are found.
    vertices: Vec<u32>,
    /// IL: for each of them, the slot of the next one anticlockwise.
    next: Vec<usize>,
    /// Under [`Boundary::All`], the points that the latest SPLIT found on its line between the ends.
    on_line: Vec<u32>,
}

impl<'a, K: Kernel2, O: Observer> Convex<'a, K, O> {
    /// The list of two vertices, which follow each other.
    fn between(
        first: u32,
        second: u32,
        points: Points<'a, 2>,
        boundary: Boundary,
        kernel: &'a K,
        observer: &'a mut O,
    ) -> Self {
        Self {
            points,
            boundary,
            kernel,
            observer,
            vertices: vec![first, second],
            next: vec![SECOND, FIRST],
            on_line: Vec::new(),
        }
    }

    /// Gives the points on the first line to a half with nothing beyond that line (invariant 4).
    fn start_half(&mut self, furthest: Option<usize>, on_first_line: &mut Vec<u32>) {
        self.on_line.clear();
        if furthest.is_none() {
            self.on_line.append(on_first_line);
        }
    }

    /// Finds the hull from the vertex in `slot` to the next one, where `current` holds the points above that
    /// edge and `furthest` is the place of the furthest of them.
    fn half(
        &mut self,
        mut slot: usize,
        mut furthest: Option<usize>,
        current: &mut Vec<u32>,
        aside: &mut Vec<u32>,
    ) {
        let mut right_sons: Vec<RightSon> = Vec::new();
        loop {
            while let Some(place) = furthest {
                let apex = current.swap_remove(place);
                self.observer.step(|| Step::Apex(apex));
                let apex_slot = self.insert_after(slot, apex);
                let before = aside.len();
                let left_edge = (self.vertices[slot], apex);
                furthest = self.split(left_edge, current, Below::Save(aside)).above;
                right_sons.push(RightSon {
                    slot: apex_slot,
                    count: aside.len() - before,
                });
                self.observer
                    .step(|| Step::Storage(right_sons.len() as u32));
            }
            self.confirm_edge(slot);
            let Some(right_son) = right_sons.pop() else {
                return;
            };
            slot = right_son.slot;
            current.extend(aside.drain(aside.len() - right_son.count..));
            let right_edge = (self.vertices[slot], self.vertices[self.next[slot]]);
            furthest = self.split(right_edge, current, Below::Drop).above;
        }
    }

    /// SPLIT: keeps in `subset` the points above the line, that is, to the right of it.
    fn split(
        &mut self,
        (from, to): (u32, u32),
        subset: &mut Vec<u32>,
        mut below: Below<'_>,
    ) -> Furthest {
        let mut furthest = Furthest::default();
        let mut kept = 0;
        self.on_line.clear();
        if !subset.is_empty() {
            self.observer.step(|| Step::Line(from, to));
        }
        for place in 0..subset.len() {
            let id = subset[place];
            self.observer.step(|| Step::Visit(id));
            let side = self
                .kernel
                .orient(self.points[from], self.points[to], self.points[id]);
            match (side, &mut below) {
                (Sign::Negative, _) => {
                    subset[kept] = id;
                    if self.is_furthest((to, from), id, furthest.above.map(|best| subset[best])) {
                        furthest.above = Some(kept);
                    }
                    kept += 1;
                }
                (Sign::Positive, Below::Save(list)) => {
                    if self.is_furthest((from, to), id, furthest.below.map(|best| list[best])) {
                        furthest.below = Some(list.len());
                    }
                    list.push(id);
                }
                (Sign::Zero, _) if self.is_boundary_point(from, to, id) => self.on_line.push(id),
                _ => self.observer.step(|| Step::Discard(id)),
            }
        }
        subset.truncate(kept);
        furthest
    }

    /// Whether `id` lies further to the left of the line than the `best` so far; of copies, the smallest index.
    fn is_furthest(&self, (from, to): (u32, u32), id: u32, best: Option<u32>) -> bool {
        let Some(best) = best else {
            return true;
        };
        let [a, b, p, q] = [from, to, id, best].map(|id| self.points[id]);
        match self.kernel.compare_distance_then_along(a, b, p, q) {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => id < best,
        }
    }

    /// Whether `id`, on the line of an edge, would count as a vertex of that edge: it lies strictly between the ends.
    fn is_boundary_point(&self, from: u32, to: u32, id: u32) -> bool {
        let [a, b, p] = [from, to, id].map(|id| self.points[id]);
        self.boundary == Boundary::All
            && self.kernel.compare_along(a, b, a, p) == Ordering::Less
            && self.kernel.compare_along(a, b, p, b) == Ordering::Less
    }

    /// Puts `id` into the list after `slot`; returns its own slot.
    fn insert_after(&mut self, slot: usize, id: u32) -> usize {
        let own = self.vertices.len();
        self.vertices.push(id);
        self.next.push(self.next[slot]);
        self.next[slot] = own;
        self.observer.step(|| Step::Insert(id));
        own
    }

    /// Confirms the edge that starts at `slot`, above which there is nothing, with the points on it as vertices.
    fn confirm_edge(&mut self, mut slot: usize) {
        let mut row = std::mem::take(&mut self.on_line);
        sort_distinct(self.points, &mut row, self.kernel);
        let (from, to) = (self.vertices[slot], self.vertices[self.next[slot]]);
        if self
            .kernel
            .lexicographic(self.points[from], self.points[to])
            == Ordering::Greater
        {
            row.reverse();
        }
        for id in row.into_iter() {
            let from = self.vertices[slot];
            slot = self.insert_after(slot, id);
            self.observer.step(|| Step::Edge(from, id));
        }
        let from = self.vertices[slot];
        self.observer.step(|| Step::Edge(from, to));
    }

    /// The vertices in the order of the list.
    fn into_hull(self) -> Hull2 {
        let following = |&slot: &usize| Some(self.next[slot]).filter(|&next| next != FIRST);
        let cycle = std::iter::successors(Some(FIRST), following)
            .map(|slot| self.vertices[slot])
            .collect();
        Hull2::from_cycle(self.points, cycle)
    }
}
