//! A triangulated surface: the working state of every spatial hull algorithm that grows one.
//!
//! Triangles live in an arena and name their three corners and their three neighbours, 24 bytes in one place. A *side*
//! is one directed edge of one triangle, numbered `4 · triangle + corner` (so that a shift tells the triangle), from
//! that corner to the next; anticlockwise seen from outside.
//!
//! ```text
//!             c                      side 4t   runs a -> b, its twin b -> a in the triangle below
//!            / \                     side 4t+1 runs b -> c
//!   4t+2    /   \  4t+1              side 4t+2 runs c -> a
//!          /  t  \
//!         a ----- b
//!             4t
//! ```
//!
//! Invariants, outside of a change to the surface:
//!
//! 1. `twin(twin(s)) == s`, and the twin of a side from p to q runs from q to p.
//! 2. Triangles that were removed are on the free list, and no living triangle is linked to one. One that was
//!    [taken out](TriMesh::take_out) is neither living nor free until [`TriMesh::replace`] uses its slot.

/// A triangle of a [`TriMesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TriangleId(pub u32);

/// A directed edge of a triangle of a [`TriMesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SideId(pub u32);

impl TriangleId {
    /// Its side from corner `corner` (0, 1 or 2) to the next.
    #[inline(always)]
    pub fn side(self, corner: u32) -> SideId {
        SideId(4 * self.0 + corner)
    }

    /// Its three sides, in order round it.
    #[inline(always)]
    pub fn sides(self) -> [SideId; 3] {
        [0, 1, 2].map(|corner| self.side(corner))
    }
}

impl SideId {
    /// The triangle it belongs to.
    #[inline(always)]
    pub fn triangle(self) -> TriangleId {
        TriangleId(self.0 / 4)
    }

    /// The side after it, round the same triangle.
    #[inline(always)]
    pub fn next(self) -> SideId {
        SideId(if self.corner() == 2 {
            self.0 - 2
        } else {
            self.0 + 1
        })
    }

    /// The side before it, round the same triangle.
    #[inline(always)]
    pub fn previous(self) -> SideId {
        SideId(if self.corner() == 0 {
            self.0 + 2
        } else {
            self.0 - 1
        })
    }

    /// The corner of its triangle, 0, 1 or 2, at which it begins.
    #[inline(always)]
    pub fn corner(self) -> u32 {
        self.0 % 4
    }

    /// The same, as a place in an array of three.
    #[inline(always)]
    fn place(self) -> usize {
        self.corner() as usize
    }

    /// Where its triangle is in the arena.
    #[inline(always)]
    fn slot(self) -> usize {
        self.0 as usize / 4
    }
}

const NONE: u32 = u32::MAX;

/// A triangulated closed surface under construction.
#[derive(Clone, Debug, Default)]
pub struct TriMesh {
    triangles: Vec<Triangle>,
    free: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Triangle {
    /// The origin of each side; [`NONE`] first if the triangle is not on the surface.
    origins: [u32; 3],
    /// The twin of each side.
    twins: [u32; 3],
}

impl TriMesh {
    /// A surface without triangles.
    pub fn new() -> Self {
        Self::default()
    }

    /// The surface of the tetrahedron abcd, where abc runs anticlockwise seen from d, that is clockwise seen from
    /// outside: the triangles acb, abd, bcd, cad.
    pub fn tetrahedron([a, b, c, d]: [u32; 4]) -> Self {
        let mut mesh = Self::new();
        let base = mesh.add([a, c, b]);
        let around = [[a, b, d], [b, c, d], [c, a, d]].map(|corners| mesh.add(corners));
        // The sides of the base run a -> c, c -> b, b -> a.
        for (wall, base_side) in around.iter().zip([2, 1, 0]) {
            mesh.link(wall.side(0), base.side(base_side));
        }
        for i in 0..3 {
            mesh.link(around[i].side(1), around[(i + 1) % 3].side(2));
        }
        mesh
    }

    /// Adds a triangle with these corners, anticlockwise seen from outside, not linked to any other.
    pub fn add(&mut self, corners: [u32; 3]) -> TriangleId {
        let triangle = Triangle {
            origins: corners,
            twins: [NONE; 3],
        };
        TriangleId(if let Some(slot) = self.free.pop() {
            self.triangles[slot as usize] = triangle;
            slot
        } else {
            self.triangles.push(triangle);
            (self.triangles.len() - 1) as u32
        })
    }

    /// Removes a triangle; its number will be used again. Its neighbours must be removed or linked anew.
    pub fn remove(&mut self, triangle: TriangleId) {
        self.take_out(triangle);
        self.free.push(triangle.0);
    }

    /// Takes a triangle off the surface, but keeps its number for [`replace`](Self::replace), to which it must be
    /// given.
    #[inline(always)]
    pub fn take_out(&mut self, triangle: TriangleId) {
        self.triangles[triangle.0 as usize].origins[0] = NONE;
    }

    /// Gives every corner another number, which must be below `u32::MAX`.
    pub fn renumber(&mut self, number: impl Fn(u32) -> u32) {
        for triangle in &mut self.triangles {
            if triangle.origins[0] != NONE {
                triangle.origins = triangle.origins.map(&number);
            }
        }
    }

    /// Makes two sides each other's twins.
    #[inline]
    pub fn link(&mut self, side: SideId, twin: SideId) {
        self.triangles[side.slot()].twins[side.place()] = twin.0;
        self.triangles[twin.slot()].twins[twin.place()] = side.0;
    }

    /// Whether the triangle is on the surface, that is, not removed.
    #[inline(always)]
    pub fn is_alive(&self, triangle: TriangleId) -> bool {
        self.triangles[triangle.0 as usize].origins[0] != NONE
    }

    /// The corners, anticlockwise seen from outside.
    #[inline(always)]
    pub fn corners(&self, triangle: TriangleId) -> [u32; 3] {
        self.triangles[triangle.0 as usize].origins
    }

    /// Where a side begins.
    #[inline(always)]
    pub fn origin(&self, side: SideId) -> u32 {
        self.triangles[side.slot()].origins[side.place()]
    }

    /// Where a side ends.
    #[inline(always)]
    pub fn target(&self, side: SideId) -> u32 {
        self.origin(side.next())
    }

    /// The corner opposite a side.
    #[inline(always)]
    pub fn apex(&self, side: SideId) -> u32 {
        self.origin(side.previous())
    }

    /// The same edge in the opposite direction, a side of the neighbour.
    #[inline(always)]
    pub fn twin(&self, side: SideId) -> SideId {
        SideId(self.triangles[side.slot()].twins[side.place()])
    }

    /// The same edges as the sides of a triangle, as sides of its neighbours.
    #[inline(always)]
    pub fn twins(&self, triangle: TriangleId) -> [SideId; 3] {
        self.triangles[triangle.0 as usize].twins.map(SideId)
    }

    /// The side after this one, clockwise, of those that begin at the same corner.
    #[inline(always)]
    pub fn next_around(&self, side: SideId) -> SideId {
        self.twin(side).next()
    }

    /// The number of slots for triangles, living or free: an upper bound on the numbers in use.
    pub fn slots(&self) -> usize {
        self.triangles.len()
    }

    /// The number of triangles on the surface.
    pub fn len(&self) -> usize {
        self.slots() - self.free.len()
    }

    /// Whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The triangles on the surface, by number.
    pub fn triangles(&self) -> impl Iterator<Item = TriangleId> + '_ {
        (0..self.slots() as u32)
            .map(TriangleId)
            .filter(|&triangle| self.is_alive(triangle))
    }

    /// Closes the hole left by visible triangles with the cone from `apex` over its rim.
    ///
    /// `horizon` holds the sides of the triangles beyond the rim that border the hole, in order round it: each
    /// begins where the one before it ends when walked against their direction, so that the new triangles
    /// (target, origin, apex) stand side by side. Returns the new triangles through `made`, in that order.
    pub fn close(&mut self, horizon: &[SideId], apex: u32, made: &mut Vec<TriangleId>) {
        made.clear();
        for &beyond in horizon {
            let triangle = self.add([self.target(beyond), self.origin(beyond), apex]);
            self.link(triangle.side(0), beyond);
            made.push(triangle);
        }
        for i in 0..made.len() {
            let next = made[(i + 1) % made.len()];
            self.link(made[i].side(1), next.side(2));
        }
    }

    /// Puts the cone from `apex` over the rim in the place of the triangles `taken_out`: as
    /// [`close`](Self::close) after [`remove`](Self::remove), but in the slots just left, while they are in the cache. Leaves the
    /// triangles of the cone in `taken_out`, in the order of `horizon`.
    ///
    /// Returns a triangle of the cone; `None` if `horizon` is not one closed walk of three sides or more past living
    /// triangles, and then the surface is of no use any more.
    pub fn replace(
        &mut self,
        taken_out: &mut Vec<TriangleId>,
        horizon: &[SideId],
        apex: u32,
    ) -> Option<TriangleId> {
        if horizon.len() < 3 {
            return None;
        }
        while taken_out.len() < horizon.len() {
            let slot = self.add([NONE; 3]);
            taken_out.push(slot);
        }
        for spare in taken_out.drain(horizon.len()..) {
            self.free.push(spare.0);
        }
        let first = taken_out[0];
        let mut before = taken_out[horizon.len() - 1];
        let mut begins = self.origin(horizon[horizon.len() - 1]);
        let mut is_closed = true;
        let after = taken_out[1..].iter().chain([&first]);
        for ((&beyond, &triangle), after) in horizon.iter().zip(&*taken_out).zip(after) {
            let neighbour = &mut self.triangles[beyond.slot()];
            let from = neighbour.origins[beyond.next().place()];
            let to = neighbour.origins[beyond.place()];
            neighbour.twins[beyond.place()] = triangle.side(0).0;
            is_closed &= (from == begins) & (neighbour.origins[0] != NONE);
            begins = to;
            self.triangles[triangle.0 as usize] = Triangle {
                origins: [from, to, apex],
                twins: [beyond.0, after.side(2).0, before.side(1).0],
            };
            before = triangle;
        }
        is_closed.then_some(before)
    }

    /// Checks the invariants: for tests and debug assertions. O(triangles).
    pub fn is_sound(&self) -> bool {
        self.triangles().all(|triangle| {
            triangle.sides().into_iter().all(|side| {
                let twin = self.twin(side);
                twin.0 != NONE
                    && self.is_alive(twin.triangle())
                    && self.twin(twin) == side
                    && self.origin(twin) == self.target(side)
                    && self.target(twin) == self.origin(side)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_is_sound_and_grows() {
        let mut mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        assert!(mesh.is_sound());
        assert_eq!(mesh.len(), 4);
        // Replace the triangle 0 1 3 by a cone from 4.
        let removed = mesh
            .triangles()
            .find(|&t| mesh.corners(t) == [0, 1, 3])
            .expect("a wall");
        let horizon = removed.sides().map(|side| mesh.twin(side));
        mesh.remove(removed);
        let mut made = Vec::new();
        mesh.close(&horizon, 4, &mut made);
        assert!(mesh.is_sound());
        assert_eq!((mesh.len(), mesh.slots()), (6, 6));
        let corners: Vec<_> = made.iter().map(|&t| mesh.corners(t)).collect();
        assert_eq!(corners, [[0, 1, 4], [1, 3, 4], [3, 0, 4]]);
        mesh.renumber(|id| 10 * id);
        assert!(mesh.is_sound());
        assert_eq!(mesh.corners(made[1]), [10, 30, 40]);
    }
}
