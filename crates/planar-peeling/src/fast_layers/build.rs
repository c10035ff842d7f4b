//! The tree of all points.

use super::chain::{Chain, EMPTY, LEFT, NONE, Place, RIGHT};
use super::hull_tree::{HullTree, NO_LEFT, NO_RIGHT};
use super::leaf::{BLOCK, Hidden, light_up};
use super::side::{Context, Side};
use geometry_core::{Kernel2, Observer};

impl<S: Side> HullTree<S> {
    /// The tree of the points of `context` at `places`. O(n): a point that a search for a bridge passes is on no
    /// hull above.
    pub(super) fn new<K: Kernel2, O: Observer>(
        places: impl Iterator<Item = Place>,
        context: &mut Context<'_, K, O>,
    ) -> Self {
        let last = context.entries.len() - 1;
        let leaves = (last + 1).div_ceil(BLOCK).next_power_of_two();
        let mut tree = Self::empty(leaves, last);
        for place in places {
            tree.hidden[place as usize / BLOCK] |= 1 << (place as usize % BLOCK) as Hidden;
        }
        tree.members.copy_from_slice(&tree.hidden);
        for leaf in 0..leaves {
            let hidden = &mut tree.hidden[leaf];
            let hull = light_up::<S, K, O>(leaf, hidden, EMPTY, &mut tree.links, context);
            tree.set_hull(leaves + leaf, hull);
        }
        for node in (1..leaves).rev() {
            tree.merge(node, context);
        }
        tree
    }

    /// Makes `hull`, whose points are linked, the hull of `node`.
    fn set_hull(&mut self, node: usize, hull: Chain) {
        if hull != EMPTY {
            self.links.set(hull[LEFT], LEFT, NONE);
            self.links.set(hull[RIGHT], RIGHT, NONE);
        }
        self.nodes[node].rest = hull;
    }

    /// Makes the hull of `node` of those of its children, and leaves them the rest.
    fn merge<K: Kernel2, O: Observer>(&mut self, node: usize, context: &mut Context<'_, K, O>) {
        let [left, right] = [LEFT, RIGHT].map(|way| self.nodes[2 * node + way].rest);
        if left == EMPTY || right == EMPTY {
            let way = if left == EMPTY { RIGHT } else { LEFT };
            self.nodes[node].bridge = if left == EMPTY { NO_LEFT } else { NO_RIGHT };
            self.nodes[node].rest = std::mem::replace(&mut self.nodes[2 * node + way].rest, EMPTY);
            return;
        }
        let [l, r] = self.common_tangent([left[RIGHT], right[LEFT]], context);
        self.nodes[node].bridge = [l, r];
        self.nodes[2 * node + LEFT].rest = self.cut(left, l, RIGHT);
        self.nodes[2 * node + RIGHT].rest = self.cut(right, r, LEFT);
        self.nodes[node].rest = self.links.join([left[LEFT], l], [r, right[RIGHT]]);
    }

    /// The common tangent, sought from the innermost points outwards.
    fn common_tangent<K: Kernel2, O: Observer>(
        &self,
        [mut l, mut r]: [Place; 2],
        context: &mut Context<'_, K, O>,
    ) -> [Place; 2] {
        let (mut left, mut right) = (context.point(l), context.point(r));
        loop {
            let before = [l, r];
            loop {
                let outer = self.links.next(l, LEFT);
                let point = context.point(outer);
                if outer == NONE || context.keeps::<S>(point, left, right) {
                    break;
                }
                (l, left) = (outer, point);
            }
            loop {
                let outer = self.links.next(r, RIGHT);
                let point = context.point(outer);
                if outer == NONE || context.keeps::<S>(left, right, point) {
                    break;
                }
                (r, right) = (outer, point);
            }
            if [l, r] == before {
                context.bridged(l, r);
                return before;
            }
        }
    }
}
