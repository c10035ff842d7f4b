//! All convex layers in O(n log n), from two trees of hulls that only shrink.
//!
//! After M. H. Overmars and J. van Leeuwen, *Maintenance of configurations in the plane*, J. Comput. System Sci. 23
//! (1981), 166-204, whose tree it is; B. Chazelle, *On the convex layers of a planar set*, IEEE Trans. Inform. Theory 31
//! (1985), 509-517, who keeps a point only at the highest node whose hull it is on; and J. Hershberger and S. Suri,
//! *Applications of a semi-dynamic convex hull algorithm*, BIT 32 (1992), 249-267, for why walking is enough when points
//! only leave.
//!
//! 1. Sort the points by x, then y.
//! 2. Build a balanced tree over them twice: one for lower hulls, one for upper hulls. A node's hull is that of its
//!    left child up to the *bridge*, the bridge, and that of its right child from there on. The node keeps the
//!    bridge and, as a list, those points of its hull that are not on its parent's.
//! 3. The lists of the two roots are the next layer.
//! 4. Take the layer out: the points of the other half one by one, each from the node that has it in its list
//!    downwards; then the whole list of the root at once. Where a node loses an end of its bridge, find the new
//!    one and hand up the points that come to light.
//! 5. Go on until the roots are empty.
//!
//! The trees hold only the *active* points, some thousands, which fit the cache; the others wait in *shells*:
//!
//! 6. Shrink the last layer so that half of the points that wait lie outside, and split them by this *outline*.
//!    Halve the outer part again until it is small enough to be active.
//! 7. Whenever the hull of the active points no longer has the next outline inside, the next shell joins them, split
//!    by the shape of the layers now; the trees are built anew.
//!
//! ```text
//!         l ------------ r            the hull of a node: ... l r ...
//!        /  \            /  \
//!       .    \          /    .         left rest: from l on inwards     right rest: up to r
//!      /      x        x      \
//!
//!      when l leaves, the points below it come to light:
//!
//!              l' ------ r            r can only move inwards, and l' lies between the
//!             / \       /  \           neighbours that l had on the hull of the left child
//!       .    /   x     x    .
//!      /                      \
//! ```
//!
//! # Bound
//!
//! O(n log n) orientations whatever the input, by invariants 6 and 9: about 1.8 n log₂ n in a disc, and twice as many for
//! triangles in one another, the dearest family known. A layer costs no more than its own points and what they
//! uncover. One sort of n integers of 16 bytes; 48 bytes a point while the shells are split, and some 70 for each that is
//! active.
//!
//! # Invariants
//!
//! 1. In lexicographic order points of one x follow each other as if the plane were sheared a little, which changes
//!    no orientation. So no two points have the same abscissa, and no line is upright.
//! 2. A point that has not been taken out is, in each tree, in exactly one place: in the list of the highest node
//!    whose hull it is on, or among the hidden points of its leaf.
//! 3. What a root's hull has in the range of a node is a contiguous piece of that node's hull: between two
//!    neighbours on a hull there is nothing above their edge. So all that leaves at once is one piece for every node.
//! 4. The links of a list go on to the neighbours that its ends have on the hull of the list's node, which a higher
//!    node owns. Only an end of the hull has no neighbour.
//! 5. If l leaves and r stays, the new bridge lies below the old one at the dividing line and passes r above or
//!    through it. So r moves inwards if at all, and l' is one of the points that came to light, or a
//!    neighbour of the piece that was taken. Walking from the innermost candidate outwards, and moving r only
//!    when the outer end has come to rest, never passes the tangent, and asks for orientations only.
//!    If both leave, the left one leaves first.
//! 6. Each step of a walk moves r onto a point that thereby joins the hull of the node, or passes a point that has
//!    just joined the hull of the child. Points never leave a hull otherwise than for good, so each point is
//!    walked over at most twice a level and tree.
//! 7. The points of a shell lie strictly inside its outline, and each outline holds those further in. While the hull of
//!    the active points has the next outline inside, no point that waits is on its boundary, and it is the
//!    hull of all.
//! 8. Then, too, a point with the outline below it is not on the lower half of the hull, and one above it not on the
//!    upper: all active points that are neither left nor right of the outline need be in one tree only.
//! 9. At least as many points join as were left, so that to build the trees anew costs O(1) a point that
//!    joins. A split leaves an eighth of the points, and one at least, on either side or is not made, so a point takes part in
//!    O(log n).
//!
//! Which points of an edge are on a hull ([`Boundary`]) is the same for all nodes, so that 3 holds under both
//! conventions: under [`Boundary::All`] the ends of a bridge are the innermost points on its line, else the outermost.
//!
//! # Departures
//!
//! The hulls are lists in the nodes of a static tree instead of queues that are cut and joined; leaves hold
//! a block of points, whose hull is a monotone chain through them. The shells are ours. Points are put in order by
//! their coordinates, not by the kernel; outlines are rounded polygons, of which it is asked what they hold.
//!
//! # When not to use it
//!
//! For a few layers of many points, or for a few hundred points: the sort and the trees then cost more than a hull a
//! layer.

mod active;
mod build;
mod chain;
mod hull_tree;
mod leaf;
mod outline;
mod shells;
mod side;
mod sorted;

use active::Active;
use geometry_core::{Boundary, HullError, Kernel2, Layers, Observer, Points};
use shells::Shells;
use side::Context;
use sorted::Sorted;

/// How many points join the active ones at a time, if so many wait.
const PORTION: usize = 4096;

/// One point in so many shows the shape of the first layers.
const SAMPLE: usize = 16;

/// The convex layers of `points` in O(n log n).
///
/// Returns the layers, outermost first, as ids of `points`; `boundary` says whether points inside an edge belong
/// to a layer. Copies of a vertex leave together with it.
///
/// # Errors
///
/// None.
///
/// # Cost
///
/// O(n log n) orientations, whatever the points; 48n bytes besides the result if few points are active at a time,
/// 70n at worst.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::fast_layers::fast_layers;
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0], [0.0, 0.0]];
/// let layers = fast_layers(Points::new(&points)?, Boundary::All, &Exact, &mut Silent)?;
/// assert_eq!(layers.c_ranks(), [1, 1, 1, 2, 1]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_layers<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Layers, HullError> {
    fast_layers_in_portions(points, boundary, PORTION, kernel, observer)
}

/// [`fast_layers`] with another number of points that join at a time. The answer is the same for all; the
/// time is least for some thousand.
///
/// # Errors
///
/// None.
///
/// # Cost
///
/// As [`fast_layers`].
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::fast_layers::{fast_layers, fast_layers_in_portions};
/// let points: Vec<[f64; 2]> = (0..99).map(|i| [f64::from(i % 10), f64::from(i * i % 11)]).collect();
/// let points = Points::new(&points)?;
/// let all = fast_layers(points, Boundary::Extreme, &Exact, &mut Silent)?;
/// let few = fast_layers_in_portions(points, Boundary::Extreme, 10, &Exact, &mut Silent)?;
/// assert_eq!(all, few);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_layers_in_portions<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    portion: usize,
    kernel: &K,
    observer: &mut O,
) -> Result<Layers, HullError> {
    let Sorted { entries, copies } = Sorted::new(points);
    let mut active = Active::new(Context::new(boundary, kernel, observer));
    let mut shape = active.shape_of(entries.iter().step_by(SAMPLE));
    let mut shells = Shells::new(entries, portion.max(1));
    let mut stages = vec![0; points.len()];
    let mut rings = Vec::new();
    loop {
        if !shells.are_within(active.halves(), kernel) {
            let left = active.left();
            let portion = shells.next(&shape, left.len(), kernel);
            active.restart(&left, &portion, shells.outline());
            continue;
        }
        if active.is_empty() {
            break;
        }
        rings.push(active.ring());
        shape = active.outline();
        active.peel(rings.len() as u32, &mut stages);
    }
    for [copy, id] in copies {
        stages[copy as usize] = stages[id as usize];
    }
    Ok(Layers::new(rings, stages))
}
