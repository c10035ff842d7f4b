//! Method GS.
//!
//! P. J. Green and B. W. Silverman, *Constructing the convex hull of a set of points in the plane*, The Computer
//! Journal 22 (1979), 262-266.
//!
//! A point is *outside* the directed line ij if it lies to its right, and *between* if it lies on it and strictly
//! between i and j. A *test list* `[ij]` holds the points found outside (and, if boundary points count, between)
//! ij, a furthest one first.
//!
//! 1. Find two points i and j certain to be on the hull: those with the smallest and the largest x. Every other
//!    point goes into `[ij]` or `[ji]`. One orientation each.
//! 2. Take a test list `[ij]`. If it is empty, ij is an edge. Otherwise let k be its furthest point: `[ij]` is replaced
//!    by `[ik]` and `[kj]`. Each point of `[ij]` is asked about ik, and only if it is not outside that, about kj. A point
//!    outside neither is inside the hull and is never looked at again.
//! 3. Repeat until only edges are left.
//!
//! ```text
//!              i ----------------------------- j
//!               \  .  inside, dropped  .   .  /
//!            [ik] \      .        .        / [kj]
//!              . .  \         .         /  .
//!                      \             /
//!                           \  /
//!                            k   furthest outside ij
//! ```
//!
//! # Bound
//!
//! O(n h) orientations at worst, reached when every line cuts off one point. Per point, in the limit of many
//! points: 3.7457 uniformly in a disc, 3 for the normal distribution, 1.5 log₂ n - 3.0 on a circle. Choosing the
//! furthest asks one comparison of distances, no orientation, per point outside a line.
//!
//! Storage beyond the points: the arrays LIST and NWK of n indices and a stack of m labels of three indices, with
//! m at most the number of peels plus the points on the largest.
//!
//! # Invariants
//!
//! 1. Read from the bottom of the confirmed edges to their top and then from the top of the open test lists to
//!    their bottom, the labels form a closed anticlockwise polygon whose vertices are extreme points (or, where
//!    a degenerate list was sorted in, boundary points) of the set.
//! 2. Every point not yet classified is in exactly one test list, and in that of the line it is outside of (or
//!    between the ends of).
//! 3. The furthest point is an extreme point: of points equally far, the one nearest to the end of the line.
//! 4. While an item of NWK is split, the cells written are fewer than the cells read: k needs none any more, and
//!    its cell becomes the second length.
//! 5. The free cells of LIST, between the peels and the tail, are at least as many as the points in test lists.
//!
//! # Departures
//!
//! 1. No tolerance here: the kernel decides which points are doubtful. With an exact kernel they are those exactly
//!    on the line and between its ends; with [`Tolerance`](geometry_core::Tolerance), those of the paper.
//! 2. A point on the base line is in neither `[ij]` nor `[ji]` until it is known which of them is empty, that is, which
//!    way the line is an edge. The paper does not say where it goes.
//! 3. Extremes are lexicographic (x, then y), and ties for the furthest are broken along the line, so that both are
//!    corners also under [`Boundary::Extreme`]. Points with one x therefore need no case of their own.
//! 4. Confirmed edges lie apart from the other labels, so that they need no sorting for step 5; together they stay
//!    within the promised m.
//! 5. A split works in blocks of a constant size, and the points outside kj wait in the free cells of LIST until
//!    the item has been read, instead of overwriting its end at once: branches then do not depend on where points
//!    lie, the lists stay in the order of the input, and memory is read in order. The same questions are asked.
//! 6. At most 2³¹ - 1 points, because a length shares its word with the flag of a degenerate list.
//! 7. The final check that the paper recommends, that the edges turn anticlockwise throughout, is left out: with an
//!    exact kernel it holds.
//!
//! # When not to use it
//!
//! When most points are extreme (on a circle, say) the logarithm is that of a sort with a larger factor: use the
//! monotone chain. When an adversary chooses the points: the worst case is quadratic.

mod arrays;
mod base;
mod bookkeeping;
mod call;
mod forming;
mod split;

pub(crate) use arrays::{Arrays, PeelLabel};
pub(crate) use bookkeeping::Peeling;

use arrays::{EDGE, Item, Label};
use bookkeeping::{Bare, Bookkeeping, Single};
use call::Call;
use geometry_core::sort::merge_sort;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Point2, Points, Step};
use std::cmp::Ordering;

/// The convex hull of `points` by method GS, as the paper has it: with the bookkeeping that peeling needs.
///
/// Returns ids of `points`, anticlockwise from the lexicographically smallest vertex; `boundary` says whether
/// points inside an edge count, as they do in the paper.
///
/// # Errors
///
/// [`HullError::TooManyPoints`] from 2³¹ points on. A rounded kernel may cause a wrong hull, but never an error.
///
/// # Cost
///
/// O(n h) orientations, on average O(n) for the usual distributions; 2n indices and a stack of at most h + 1
/// labels.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::gs::gs;
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
/// let hull = |boundary| gs(Points::new(&points)?, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 2, 3, 4]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 1, 2, 3, 4]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn gs<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    single_hull(points, boundary, kernel, observer, &mut Single)
}

/// [`gs`] without the bookkeeping that peeling needs: interior points are not written back into LIST.
///
/// The same source, compiled with another policy. It exists to time what the bookkeeping costs.
///
/// # Errors
///
/// As [`gs`].
///
/// # Cost
///
/// As [`gs`], less one write per interior point.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::gs::gs_bare;
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 3.0]];
/// let hull = gs_bare(Points::new(&points)?, Boundary::Extreme, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 3]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn gs_bare<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    single_hull(points, boundary, kernel, observer, &mut Bare)
}

fn single_hull<K: Kernel2, O: Observer, B: Bookkeeping>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
    bookkeeping: &mut B,
) -> Result<Hull2, HullError> {
    let mut arrays = arrays_for(points)?;
    if points.is_empty() {
        return Ok(Hull2::Empty);
    }
    let label = next_peel(points, boundary, kernel, observer, bookkeeping, &mut arrays);
    Ok(hull_of_peel(points, &arrays, label))
}

/// The arrays for `points`, none of them peeled.
///
/// # Errors
///
/// [`HullError::TooManyPoints`] if a length would not fit beside its flag (departure 6).
pub(crate) fn arrays_for(points: Points<'_, 2>) -> Result<Arrays, HullError> {
    let count = points.len();
    match i32::try_from(count) {
        Ok(_) => Ok(Arrays::new(points.ids().end)),
        Err(_) => Err(HullError::TooManyPoints { count }),
    }
}

/// The peel as a hull.
pub(crate) fn hull_of_peel(points: Points<'_, 2>, arrays: &Arrays, label: PeelLabel) -> Hull2 {
    let ids = arrays.peel(label).to_vec();
    if label.flat && ids.len() > 1 {
        return Hull2::Segment(ids);
    }
    Hull2::from_cycle(points, ids)
}

/// One call of the paper's routine: moves the next peel from the tail of LIST, which holds at least one point, to
/// the end of its front, and returns its label.
pub(crate) fn next_peel<K: Kernel2, O: Observer, B: Bookkeeping>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
    bookkeeping: &mut B,
    arrays: &mut Arrays,
) -> PeelLabel {
    let mut call = Call {
        points,
        boundary,
        kernel,
        observer,
        bookkeeping,
    };
    // Steps 1 and 2.
    let (i, j) = call.take_extremes(arrays);
    let flat = match j {
        None => {
            call.discard_copies(arrays);
            arrays.edges.push(Label {
                from: i,
                to: i,
                at: EDGE,
            });
            true
        }
        Some(j) => call.split_base(arrays, i, j), // Step 3.
    };
    // Step 4.
    while let Some(label) = arrays.open.pop() {
        match arrays.item(label) {
            Item::Empty => call.confirm(arrays, label.from, label.to),
            Item::Single(k) => {
                call.confirm(arrays, label.from, k);
                call.confirm(arrays, k, label.to);
            }
            Item::Degenerate { len } => call.confirm_degenerate(arrays, label, len),
            Item::Proper { len } => call.split(arrays, label, len),
        }
        call.observer.step(|| Step::Storage(arrays.labels()));
    }
    // Steps 5 and 6.
    record_peel(arrays, flat)
}

impl<K: Kernel2, O: Observer, B: Bookkeeping> Call<'_, K, O, B> {
    /// Steps 1 and 2: takes the lexicographically smallest and largest point off the tail of LIST. The second is
    /// `None` if all points left are copies of one.
    fn take_extremes(&mut self, arrays: &mut Arrays) -> (u32, Option<u32>) {
        let points = self.points;
        let start = arrays.tail;
        let list = &mut arrays.list[..];
        let (mut least, mut most) = (list.len() - 1, list.len() - 1);
        let [mut low, mut high] = [points[list[least]]; 2];
        for cell in (start..list.len()).rev() {
            let id = list[cell];
            let point = points[id];
            self.observer.step(|| Step::Visit(id));
            match self.kernel.lexicographic(point, low) {
                Ordering::Less => (least, low) = (cell, point),
                Ordering::Equal if id < list[least] => least = cell,
                _ => {}
            }
            match self.kernel.lexicographic(point, high) {
                Ordering::Greater => (most, high) = (cell, point),
                Ordering::Equal if id < list[most] => most = cell,
                _ => {}
            }
        }
        list.swap(start, least);
        if self.are_copies(low, high) {
            arrays.tail = start + 1;
            return (list[start], None);
        }
        let most = if most == start { least } else { most };
        list.swap(start + 1, most);
        arrays.tail = start + 2;
        (list[start], Some(list[start + 1]))
    }

    /// All points in the tail of LIST are copies of the one just taken off it.
    fn discard_copies(&mut self, arrays: &mut Arrays) {
        for &id in &arrays.list[arrays.tail..] {
            self.bookkeeping.copy(id, self.observer);
        }
        arrays.tail = arrays.list.len();
    }

    /// Step 4b: sorts the points of a degenerate item along the line, each of them a vertex.
    fn confirm_degenerate(&mut self, arrays: &mut Arrays, label: Label, len: usize) {
        let points = self.points;
        let start = label.at as usize + 1;
        let item = start..start + len;
        let [a, b] = [points[label.from], points[label.to]];
        let free = &mut arrays.list[arrays.front..arrays.tail]; // long enough by invariant 5
        merge_sort(&mut arrays.nwk[item.clone()], free, |p, q| {
            self.kernel
                .compare_along(a, b, points[p], points[q])
                .then(p.cmp(&q))
        });
        let mut last = label.from;
        for place in item {
            let id = arrays.nwk[place];
            if self.are_copies(points[id], points[last]) {
                self.bookkeeping.copy(id, self.observer);
            } else {
                self.confirm(arrays, last, id);
                last = id;
            }
        }
        self.confirm(arrays, last, label.to);
    }

    fn are_copies(&self, p: Point2, q: Point2) -> bool {
        self.kernel.lexicographic(p, q).is_eq()
    }

    /// The directed line from→to is an edge.
    fn confirm(&mut self, arrays: &mut Arrays, from: u32, to: u32) {
        self.observer.step(|| Step::Edge(from, to));
        arrays.edges.push(Label { from, to, at: EDGE });
    }
}

/// Steps 5 and 6: lists the vertices at the front of LIST and labels them as a peel.
fn record_peel(arrays: &mut Arrays, flat: bool) -> PeelLabel {
    let at = arrays.front;
    for label in arrays.edges.drain(..) {
        arrays.list[arrays.front] = label.from;
        arrays.front += 1;
    }
    let label = PeelLabel {
        at: at as u32,
        len: (arrays.front - at) as u32,
        flat,
    };
    arrays.peels.push(label);
    label
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::{Exact, Silent};

    /// "Two INTEGER arrays of length n": they are made with the first call and never grow.
    #[test]
    fn the_two_arrays_have_length_n_throughout() {
        let lattice = (0..144).map(|cell| [f64::from(cell % 12), f64::from(cell / 12)]);
        let points: Vec<[f64; 2]> = lattice.chain([[3.0, 3.0], [0.0, 0.0]]).collect();
        let points = Points::new(&points).expect("finite points");
        for boundary in [Boundary::Extreme, Boundary::All] {
            let mut arrays = arrays_for(points).expect("few points");
            let mut peeled = 0;
            while arrays.left() > 0 {
                let left = arrays.left();
                let label = next_peel(
                    points,
                    boundary,
                    &Exact,
                    &mut Silent,
                    &mut Single,
                    &mut arrays,
                );
                peeled += label.len as usize;
                assert!(arrays.left() < left);
                assert_eq!(
                    [arrays.front, label.at as usize + label.len as usize],
                    [peeled; 2]
                );
                assert_eq!(
                    [arrays.list.len(), arrays.list.capacity()],
                    [points.len(); 2]
                );
                assert_eq!([arrays.nwk.len(), arrays.nwk.capacity()], [points.len(); 2]);
            }
            // The two copies are not vertices of any peel.
            assert_eq!(peeled, points.len() - 2);
        }
    }
}
