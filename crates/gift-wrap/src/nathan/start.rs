//! Steps 1 and 2: the first point and the first edge, in the shadow on the x-y plane.

use super::{Start, Wrapping};
use geometry_core::{Axis, Kernel3, Observer, Step};

impl<K: Kernel3, O: Observer> Wrapping<'_, K, O> {
    /// Step 1; `None` of no points.
    pub(super) fn first_point(&self) -> Option<u32> {
        // The one place where coordinates are compared: the paper's own start is on trial, not its kernel.
        let squared_distance = |id: u32| {
            let [x, y, _] = self.points[id];
            x * x + y * y
        };
        let ids = self.ids.iter().copied();
        ids.reduce(|first, id| {
            let is_better = match self.options.start {
                Start::Furthest => squared_distance(id) > squared_distance(first),
                Start::Nearest => squared_distance(id) < squared_distance(first),
                Start::Lexicographic => self
                    .kernel
                    .lexicographic3(self.points[id], self.points[first])
                    .is_lt(),
            };
            if is_better { id } else { first }
        })
    }

    /// Step 2: the first edge from `first`, in the order of the array, that has no flattened point on its right.
    pub(super) fn first_edge(&mut self, first: u32) -> Option<[u32; 2]> {
        let others = self.ids.iter().copied().filter(|&id| id != first);
        for id in others {
            self.observer.step(|| Step::Line(first, id));
            let [from, to] = [first, id].map(|id| self.points[id]);
            let outside = |p: &u32| {
                let side = self.kernel.shadow(Axis::Z, from, to, self.points[*p]);
                side.is_negative()
            };
            let refuter = self.ids.iter().position(outside);
            let tests = refuter.map_or(self.ids.len(), |place| place + 1);
            self.run.edge_tests += tests as u64;
            if refuter.is_none() {
                return Some([first, id]);
            }
        }
        None
    }
}
