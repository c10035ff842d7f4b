//! All convex layers in O(n log n), from two trees of hulls that only shrink.
//!
//! After M. H. Overmars and J. van Leeuwen, *Maintenance of configurations in the plane*, J. Comput. System Sci. 23
//! (1981), 166-204, whose tree it is; B. Chazelle, *On the convex layers of a planar set*, IEEE Trans. Inform. Theory 31
//! (1985), 509-517, who keeps a point only at the highest node whose hull it is on; and J. Hershberger and S. Suri,
//! *Applications of a semi-dynamic convex hull algorithm*, BIT 32 (1992), 249-267, for why walking is enough when points
//! only leave.
//!
//! 1. Sort the points by x, then y. Build a balanced tree over them twice: one for lower hulls, one for upper hulls.
//! 2. A node's hull is that of its left child up to the *bridge*, the bridge, and that of its right child from
//!    there on. The node keeps the bridge and, as a list, those points of its hull that are not on its parent's.
//! 3. The lists of the two roots are the next layer.
//! 4. Take the layer out: the points of the other half one by one, each from the node that has it in its list
//!    downwards; then the whole list of the root at once. Where a node loses an end of its bridge, find the new
//!    one and hand up the points that come to light.
//! 5. Go on until the roots are empty.
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
//! O(n log n) orientations whatever the input: see invariant 6. In a disc about 2.3 n log₂ n. A layer costs no
//! more than its own points and what they uncover, so no input is worse than another by more than a constant; the
//! dearest known, triangles in one another, takes twice the questions of a disc. One sort of n integers of 16 bytes;
//! then 36 bytes a point and 2 bytes for the nodes.
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
//!
//! Which points of an edge are on a hull ([`Boundary`]) is the same for all nodes, so that 3 holds under both
//! conventions: under [`Boundary::All`] the ends of a bridge are the innermost points on its line, else the outermost.
//!
//! # Departures
//!
//! The hulls are lists in the nodes of a static tree instead of queues that are cut and joined; leaves hold
//! a block of points, whose hull is a monotone chain through them. Points are put in order by their coordinates, not by the kernel.
//!
//! # When not to use it
//!
//! For the first few layers only of many points: the trees cost as much as some twenty hulls.

mod build;
mod chain;
mod hull_tree;
mod leaf;
mod side;
mod sorted;

use chain::Place;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Layers, Observer, Points, Step};
use hull_tree::HullTree;
use side::{Context, Lower, Upper};
use sorted::Sorted;

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
/// O(n log n) orientations, whatever the points; 38n bytes besides the result, 16n more while they are sorted.
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
    let sorted = Sorted::new(points);
    let mut context = Context {
        sorted: &sorted,
        boundary,
        kernel,
        observer,
    };
    let mut lower = HullTree::<Lower>::new(&mut context);
    let mut upper = HullTree::<Upper>::new(&mut context);
    let mut stages = vec![0; points.len()];
    let mut rings = Vec::new();
    let (mut below, mut above) = (Vec::new(), Vec::new());
    loop {
        lower.read_hull(&mut below);
        upper.read_hull(&mut above);
        if below.is_empty() {
            break;
        }
        let ring = ring(&below, &above, &sorted.ids);
        let stage = rings.len() as u32 + 1;
        for &id in ring.vertices() {
            stages[id as usize] = stage;
        }
        rings.push(ring);
        upper.take_hull_and(&below, &mut context);
        lower.take_hull_and(&above, &mut context);
        context.observer.step(|| Step::Layer(stage));
    }
    for &(copy, place) in &sorted.copies {
        stages[copy as usize] = stages[sorted.ids[place as usize] as usize];
    }
    Ok(Layers::new(rings, stages))
}

/// The ring whose lower and upper halves, from left to right, are `below` and `above`.
fn ring(below: &[Place], above: &[Place], ids: &[u32]) -> Hull2 {
    let id = |&place: &Place| ids[place as usize];
    if let [only] = below {
        return Hull2::Point(id(only));
    }
    if below == above {
        return Hull2::Segment(below.iter().map(id).collect());
    }
    let inner = above.get(1..above.len() - 1).unwrap_or_default();
    let mut cycle = Vec::with_capacity(below.len() + inner.len());
    cycle.extend(below.iter().map(id));
    cycle.extend(inner.iter().rev().map(id));
    Hull2::Polygon(cycle)
}
