//! The horizon of a point over a convex surface, by depth-first search: what both spatial quickhulls do to a facet.
//!
//! From a facet that the point sees, the search crosses every edge to a facet that it sees as well. An edge to one
//! that it does not see is on the horizon. The sides of a triangle are taken in order round it, from the one through
//! which it was entered, so the edges of the horizon come in order round the visible facets:
//!
//! ```text
//!         .---1---.           entered at f; the search walks along the inside of the rim,
//!        / \     / \          and meets it in the order 1, 2, 3, 4, 5
//!       5   \ f /   2
//!      /     \ /     \        a stack of sides stands for the recursion
//!     '---4---'---3---'
//! ```
//!
//! Invariants:
//!
//! 1. Each facet is asked about at most once for each point.
//! 2. Between searches every mark is `Unknown`.

use geometry_core::HullError;
use geometry_core::mesh::{SideId, TriMesh, TriangleId};

/// Only with a kernel that is not exact.
pub(crate) const NOT_ONE_REGION: HullError = HullError::Contradiction {
    what: "the facets that a point sees are not one region with one rim",
};

/// What is known of a facet in the search under way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Mark {
    #[default]
    Unknown,
    Visible,
    Beyond,
}

/// A search for the horizon. Its vectors are used again for the next one.
#[derive(Debug, Default)]
pub(crate) struct Horizon {
    /// The facets that the point sees, in the order they were found.
    pub(crate) visible: Vec<TriangleId>,
    /// The sides, of facets that it does not see, that border those it sees, in order for [`TriMesh::close`].
    pub(crate) rim: Vec<SideId>,
    marks: Vec<Mark>,
    to_cross: Vec<SideId>,
}

impl Horizon {
    /// Finds what a point sees from outside the facet `start`; `sees` tells whether it sees a facet.
    ///
    /// # Errors
    ///
    /// [`HullError::Contradiction`] if what it sees is not one region with one rim.
    pub(crate) fn search(
        &mut self,
        mesh: &TriMesh,
        start: TriangleId,
        sees: impl FnMut(TriangleId) -> bool,
    ) -> Result<(), HullError> {
        self.explore(mesh, start, sees);
        self.check(mesh)
    }

    /// The same, for [`TriMesh::replace`] to find out whether it is one region.
    #[inline]
    pub(crate) fn explore(
        &mut self,
        mesh: &TriMesh,
        start: TriangleId,
        mut sees: impl FnMut(TriangleId) -> bool,
    ) {
        self.visible.clear();
        self.rim.clear();
        self.marks.resize(mesh.slots(), Mark::Unknown);
        self.take_up(start, start.sides());
        while let Some(side) = self.to_cross.pop() {
            let twin = mesh.twin(side);
            let neighbour = twin.triangle();
            if self.marks[neighbour.0 as usize] == Mark::Unknown {
                if sees(neighbour) {
                    self.take_up(neighbour, [twin.next(), twin.previous()]);
                    continue;
                }
                self.marks[neighbour.0 as usize] = Mark::Beyond;
            }
            if self.marks[neighbour.0 as usize] == Mark::Beyond {
                self.rim.push(twin);
            }
        }
        self.forget_marks();
    }

    /// Marks a facet as visible, to be left through `sides` in this order.
    fn take_up<const N: usize>(&mut self, facet: TriangleId, sides: [SideId; N]) {
        self.marks[facet.0 as usize] = Mark::Visible;
        self.visible.push(facet);
        self.to_cross.extend(sides.iter().rev());
    }

    /// Establishes invariant 2.
    fn forget_marks(&mut self) {
        let beyond = self.rim.iter().map(|side| side.triangle());
        for facet in self.visible.iter().copied().chain(beyond) {
            self.marks[facet.0 as usize] = Mark::Unknown;
        }
    }

    /// Whether the rim is one closed walk.
    fn check(&self, mesh: &TriMesh) -> Result<(), HullError> {
        let following = self.rim[1.min(self.rim.len())..]
            .iter()
            .chain(self.rim.first());
        let closed = self
            .rim
            .iter()
            .zip(following)
            .all(|(&side, &next)| mesh.origin(side) == mesh.target(next));
        if closed && self.rim.len() >= 3 {
            Ok(())
        } else {
            Err(NOT_ONE_REGION)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_facet_is_bordered_by_its_three_sides() -> Result<(), HullError> {
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        let start = TriangleId(1);
        let mut horizon = Horizon::default();
        for _ in 0..2 {
            let mut asked = Vec::new();
            horizon.search(&mesh, start, |facet| {
                asked.push(facet.0);
                false
            })?;
            assert_eq!(horizon.visible, [start]);
            assert_eq!(horizon.rim, start.sides().map(|side| mesh.twin(side)));
            asked.sort_unstable();
            assert_eq!(asked, [0, 2, 3]);
        }
        Ok(())
    }

    #[test]
    fn the_rim_goes_round_several_facets() -> Result<(), HullError> {
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        let mut horizon = Horizon::default();
        horizon.search(&mesh, TriangleId(1), |facet| facet.0 != 0)?;
        assert_eq!(horizon.visible.len(), 3);
        let rim: Vec<_> = horizon.rim.iter().map(|&side| mesh.target(side)).collect();
        assert_eq!(rim, [0, 1, 2]);
        Ok(())
    }

    #[test]
    fn seeing_everything_is_a_contradiction() {
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        let result = Horizon::default().search(&mesh, TriangleId(0), |_| true);
        assert!(matches!(result, Err(HullError::Contradiction { .. })));
    }
}
