//! One half of the hull of a set that only shrinks.

use super::chain::{Chain, EMPTY, LEFT, Links, NONE, Place, RIGHT};
use super::leaf::{BLOCK, Hidden, light_up};
use super::side::{Context, Side};
use geometry_core::{Kernel2, Observer, Point2};
use std::marker::PhantomData;

/// Names a node. The root is 1; the children of v are 2v, which holds the left half of its points, and 2v + 1.
type NodeId = usize;

/// What is kept of a node. A leaf has no bridge.
#[derive(Clone, Copy, Default)]
pub(super) struct Node {
    /// The ends of the edge that joins the hulls of the children. Of a node with one child left that child
    /// takes everything: [`NO_LEFT`] lies to the left of every point, [`NO_RIGHT`] to the right.
    pub(super) bridge: [Place; 2],
    /// The hull's points that are not on the parent's hull.
    pub(super) rest: Chain,
}

pub(super) const NO_LEFT: [Place; 2] = [Place::MIN; 2];
pub(super) const NO_RIGHT: [Place; 2] = [Place::MAX; 2];

/// One half of the hull of a set that only shrinks.
pub(super) struct HullTree<S> {
    pub(super) nodes: Vec<Node>,
    pub(super) links: Links,
    /// By leaf, the points not on its hull.
    pub(super) hidden: Vec<Hidden>,
    /// By leaf, the points that the tree began with.
    pub(super) members: Vec<Hidden>,
    side: PhantomData<S>,
}

/// Where a piece of a node's hull is taken out: its first and last point, and the neighbours that stay.
#[derive(Clone, Copy)]
pub(super) struct Gap {
    pub(super) taken: Chain,
    pub(super) beyond: Chain,
}

impl<S: Side> HullTree<S> {
    /// A tree of `leaves` leaves, a power of two, for places up to `last`; nothing in it.
    pub(super) fn empty(leaves: usize, last: usize) -> Self {
        Self {
            nodes: vec![Node::default(); 2 * leaves],
            links: Links::new(last),
            hidden: vec![0; leaves],
            members: vec![0; leaves],
            side: PhantomData,
        }
    }

    pub(super) fn leaves(&self) -> usize {
        self.hidden.len()
    }

    /// Reads the hull into `hull`, from left to right.
    pub(super) fn read_hull(&self, hull: &mut Vec<Place>) {
        hull.clear();
        let [first, last] = self.nodes[1].rest;
        let mut place = first;
        while place != NONE {
            hull.push(place);
            place = if place == last {
                NONE
            } else {
                self.links.next(place, RIGHT)
            };
        }
    }

    /// Takes out all points of the hull, and `others`, which may be on it too.
    pub(super) fn take_hull_and<K: Kernel2, O: Observer>(
        &mut self,
        others: &[Place],
        context: &mut Context<'_, K, O>,
    ) {
        for &place in others {
            self.take_below(place, context);
        }
        let taken = self.nodes[1].rest;
        if taken != EMPTY {
            let gap = Gap {
                taken,
                beyond: EMPTY,
            };
            self.nodes[1].rest = self.refill(1, gap, context);
        }
    }

    /// Takes out one point, unless it is on the hull or has never been there.
    fn take_below<K: Kernel2, O: Observer>(
        &mut self,
        place: Place,
        context: &mut Context<'_, K, O>,
    ) {
        let leaf = place as usize / BLOCK;
        let bit = 1 << (place as usize % BLOCK);
        if self.hidden[leaf] & bit != 0 {
            self.hidden[leaf] ^= bit;
            return;
        }
        if self.members[leaf] & bit == 0 {
            return;
        }
        let owner = self.owner(self.leaves() + leaf, place);
        if owner == 1 {
            return;
        }
        let beyond = [LEFT, RIGHT].map(|way| self.links.next(place, way));
        let gap = Gap {
            taken: [place; 2],
            beyond,
        };
        let fresh = self.refill(owner, gap, context);
        self.splice(owner, place, fresh, beyond);
    }

    /// The highest node at or above `node` whose hull `place` is on; it is on that of `node`.
    fn owner(&self, mut node: NodeId, place: Place) -> NodeId {
        while node > 1 {
            let [l, r] = self.nodes[node / 2].bridge;
            let on_parent = if node % 2 == LEFT {
                place <= l
            } else {
                place >= r
            };
            if !on_parent {
                break;
            }
            node /= 2;
        }
        node
    }

    /// Puts `fresh` where `place` was in the rest of `owner`. The neighbours `beyond` may belong to an ancestor.
    fn splice(&mut self, owner: NodeId, place: Place, fresh: Chain, beyond: Chain) {
        let old = self.nodes[owner].rest;
        if fresh == EMPTY && old == [place; 2] {
            self.nodes[owner].rest = EMPTY;
            return;
        }
        if fresh != EMPTY {
            self.links.set(fresh[LEFT], LEFT, beyond[LEFT]);
            self.links.set(fresh[RIGHT], RIGHT, beyond[RIGHT]);
        }
        for way in [LEFT, RIGHT] {
            let back = 1 - way;
            let next = if fresh == EMPTY {
                beyond[back]
            } else {
                fresh[way]
            };
            if old[way] == place {
                self.nodes[owner].rest[way] = next;
                self.links.set(next, way, beyond[way]);
            } else {
                self.links.set(beyond[way], back, next);
            }
        }
    }

    /// Takes the gap's points out of the subtree of `node`, and returns the points that come to light on its hull. The
    /// gap is a contiguous piece of that hull (invariant 3).
    pub(super) fn refill<K: Kernel2, O: Observer>(
        &mut self,
        mut node: NodeId,
        gap: Gap,
        context: &mut Context<'_, K, O>,
    ) -> Chain {
        let Gap {
            taken: [a, b],
            beyond: [before, after],
        } = gap;
        // Down to where the gap takes an end of the bridge: above, hulls change inside one child only.
        let (l, r) = loop {
            if node >= self.leaves() {
                return self.refill_leaf(node, gap.beyond, context);
            }
            let [l, r] = self.nodes[node].bridge;
            if b < l {
                node = 2 * node + LEFT;
            } else if a > r {
                node = 2 * node + RIGHT;
            } else {
                break (l, r);
            }
        };
        // Read before the left child loses its end: afterwards points of the right child may have moved up.
        let innermost = self.nodes[2 * node + RIGHT].rest[RIGHT];
        let mut fresh = EMPTY;
        if a <= l {
            let gap = Gap {
                taken: [a, l],
                beyond: [before, self.nodes[2 * node + LEFT].rest[LEFT]],
            };
            let lit = self.refill(2 * node + LEFT, gap, context);
            fresh = self.rebridge::<LEFT, K, O>(node, lit, before, context);
        }
        if b >= r {
            let gap = Gap {
                taken: [r, b],
                beyond: [innermost, after],
            };
            let lit = self.refill(2 * node + RIGHT, gap, context);
            // If the bridge has moved inwards from r already, it stays where it is.
            let lit = if self.nodes[node].bridge[RIGHT] == r {
                self.rebridge::<RIGHT, K, O>(node, lit, after, context)
            } else {
                lit
            };
            fresh = self.links.join(fresh, lit);
        }
        fresh
    }

    /// Finds the bridge of `node` when child `NEAR` has lost its end of it, and `lit` has come to light there, next
    /// to `anchor`. Returns the points that come to light on the hull of `node`, and leaves the children the rest
    /// (invariant 2).
    fn rebridge<const NEAR: usize, K: Kernel2, O: Observer>(
        &mut self,
        node: NodeId,
        lit: Chain,
        anchor: Place,
        context: &mut Context<'_, K, O>,
    ) -> Chain {
        let far = 1 - NEAR;
        let (child, other) = (2 * node + NEAR, 2 * node + far);
        let inner = self.nodes[child].rest;
        self.connect::<NEAR>(anchor, lit, inner);
        let start = [inner[NEAR], lit[far], anchor]
            .into_iter()
            .find(|&place| place != NONE);
        let Some(start) = start else {
            self.nodes[node].bridge = if NEAR == LEFT { NO_LEFT } else { NO_RIGHT };
            return std::mem::replace(&mut self.nodes[other].rest, EMPTY);
        };
        let old = self.nodes[node].bridge[far];
        let edge = self.nodes[other].rest;
        let [near_end, far_end] =
            self.tangent::<NEAR, K, O>([start, anchor], [old, edge[far]], context);
        self.nodes[node].bridge[NEAR] = near_end;
        self.nodes[node].bridge[far] = far_end;

        let all = self.links.join_towards(far, lit, inner);
        let mut from_child = EMPTY;
        self.nodes[child].rest = all;
        if near_end != anchor {
            from_child[NEAR] = all[NEAR];
            from_child[far] = near_end;
            self.nodes[child].rest = self.cut(all, near_end, far);
        }
        let mut from_other = EMPTY;
        if far_end != old {
            from_other[NEAR] = far_end;
            from_other[far] = edge[far];
            self.nodes[other].rest = self.cut(edge, far_end, NEAR);
        }
        self.links.join_towards(far, from_child, from_other)
    }

    /// What `chain` holds beyond `place` in direction `way`.
    pub(super) fn cut(&self, chain: Chain, place: Place, way: usize) -> Chain {
        if chain[way] == place {
            return EMPTY;
        }
        let mut beyond = chain;
        beyond[1 - way] = self.links.next(place, way);
        beyond
    }

    /// Keeps invariant 4: links `lit` between `anchor` and `inner`, which lies on the far side of it.
    fn connect<const NEAR: usize>(&mut self, anchor: Place, lit: Chain, inner: Chain) {
        let far = 1 - NEAR;
        if lit != EMPTY {
            self.links.set(lit[NEAR], NEAR, anchor);
            self.links.set(lit[far], far, inner[NEAR]);
        }
        if inner != EMPTY {
            let next = if lit == EMPTY { anchor } else { lit[far] };
            self.links.set(inner[NEAR], NEAR, next);
        }
    }

    /// The common tangent of a chain that changed and one that did not. Both ends walk towards `NEAR`: on the
    /// changed chain from `start` and no further than `anchor`, on the other from `old` and on from `next`
    /// (invariant 5).
    fn tangent<const NEAR: usize, K: Kernel2, O: Observer>(
        &self,
        [start, anchor]: [Place; 2],
        [old, next]: [Place; 2],
        context: &mut Context<'_, K, O>,
    ) -> [Place; 2] {
        let keeps = |context: &Context<'_, K, O>, outer: Point2, middle: Point2, inner: Point2| {
            if NEAR == LEFT {
                context.keeps::<S>(outer, middle, inner)
            } else {
                context.keeps::<S>(inner, middle, outer)
            }
        };
        let (mut near_end, mut far_end, mut further) = (start, old, next);
        let (mut near, mut far) = (context.point(near_end), context.point(far_end));
        loop {
            while near_end != anchor {
                let outer_end = self.links.next(near_end, NEAR);
                let outer = context.point(outer_end);
                if outer_end == NONE || keeps(context, outer, near, far) {
                    break;
                }
                (near_end, near) = (outer_end, outer);
            }
            let inner = context.point(further);
            if further == NONE || !keeps(context, near, inner, far) {
                break;
            }
            (far_end, far) = (further, inner);
            further = self.links.next(far_end, NEAR);
        }
        context.bridged(near_end, far_end);
        [near_end, far_end]
    }

    /// Takes the points between `beyond` that come to light in a leaf out of hiding.
    fn refill_leaf<K: Kernel2, O: Observer>(
        &mut self,
        node: NodeId,
        beyond: Chain,
        context: &mut Context<'_, K, O>,
    ) -> Chain {
        let leaf = node - self.leaves();
        light_up::<S, K, O>(
            leaf,
            &mut self.hidden[leaf],
            beyond,
            &mut self.links,
            context,
        )
    }
}
