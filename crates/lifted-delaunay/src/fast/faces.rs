//! The faces of a triangulation and of its outside, glued along their edges.
//!
//! The outside is made of triangles, too: every edge of the hull has a *ghost*, whose third corner is [`OUTSIDE`], and the
//! ghosts of neighbours on the hull are neighbours. So there is a face on either side of every edge, also where all points are
//! collinear, and to remove an edge of the hull is to flip it.
//!
//! ```text
//!        OUTSIDE
//!         /   \          the ghost of the edge a -> b of the hull, anticlockwise:
//!        /     \         its edges are b -> a, a -> OUTSIDE and OUTSIDE -> b
//!       a ----- b
//!        inside
//! ```
//!
//! **Room.** By Euler's formula m ≥ 2 points have 2 m - 2 faces, ghosts included. So those of the sites from i up to j are
//! the faces from 2 i up to 2 j - 2, and joining two parts adds the two between theirs: no list says which are free. Places
//! stay unused, as zeros, where there are copies of points.

use rayon::prelude::*;
use std::ops::Range;

/// Faces that one thread takes at a time.
const STRETCH: usize = 1 << 16;

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// The corner of ghosts that is no vertex.
pub(super) const OUTSIDE: u32 = u32::MAX;

/// Of a face: first its corners, anticlockwise, then the [twins](Faces::twin) of the edges that start there. Arrays rather
/// than a struct, so that memory comes zeroed from the system and is only touched where faces are.
pub(super) type Triple = [u32; 3];

/// Faces for each vertex, and triples for each of them.
pub(super) const FACES_PER_VERTEX: usize = 2;
pub(super) const TRIPLES_PER_VERTEX: usize = 2 * FACES_PER_VERTEX;

/// How many numbers a face takes of those of edges: the edge from corner k of face f is 4 f + k.
pub(super) const EDGES_PER_FACE: u32 = 4;

/// The faces, of which those that were not set yet are zeros.
#[derive(Debug)]
pub(super) struct Faces<'a> {
    triples: &'a mut [Triple],
}

/// The first edge of a face.
#[inline(always)]
pub(super) fn edge_of(face: u32) -> u32 {
    EDGES_PER_FACE * face
}

/// The next edge of the same face, anticlockwise.
#[inline(always)]
pub(super) fn next(e: u32) -> u32 {
    (e & !3) | ((0b00_10_01 >> (2 * (e & 3))) & 3)
}

/// The previous edge of the same face.
#[inline(always)]
pub(super) fn prev(e: u32) -> u32 {
    (e & !3) | ((0b01_00_10 >> (2 * (e & 3))) & 3)
}

impl<'a> Faces<'a> {
    pub(super) fn new(triples: &'a mut [Triple]) -> Self {
        Self { triples }
    }

    /// The same edge, seen from the face on its other side.
    #[inline(always)]
    pub(super) fn twin(&self, e: u32) -> u32 {
        self.triples[((e >> 1) | 1) as usize][(e & 3) as usize]
    }

    /// Where the edge starts.
    #[inline(always)]
    pub(super) fn origin(&self, e: u32) -> u32 {
        self.triples[((e >> 1) & !1) as usize][(e & 3) as usize]
    }

    /// The corner of the face that the edge does not touch.
    #[inline(always)]
    pub(super) fn apex(&self, e: u32) -> u32 {
        self.origin(prev(e))
    }

    /// Sets the corners of a face, whose first edge is given.
    #[inline(always)]
    pub(super) fn set_corners(&mut self, first: u32, corners: [u32; 3]) {
        self.triples[(first >> 1) as usize] = corners;
    }

    #[inline(always)]
    pub(super) fn set_origin(&mut self, e: u32, vertex: u32) {
        self.triples[((e >> 1) & !1) as usize][(e & 3) as usize] = vertex;
    }

    /// Makes two edges each other's twins.
    #[inline(always)]
    pub(super) fn glue(&mut self, e: u32, f: u32) {
        self.triples[((e >> 1) | 1) as usize][(e & 3) as usize] = f;
        self.triples[((f >> 1) | 1) as usize][(f & 3) as usize] = e;
    }

    /// Makes ghosts, from the face `first` on, of a hull with these vertices, anticlockwise, and glues them to each other.
    #[inline(always)]
    pub(super) fn surround<const N: usize>(&mut self, first: u32, hull: [u32; N]) {
        for i in 0..N {
            let ghost = edge_of(first + i as u32);
            let after = edge_of(first + ((i + 1) % N) as u32);
            self.set_corners(ghost, [hull[(i + 1) % N], hull[i], OUTSIDE]);
            self.glue(prev(ghost), next(after));
        }
    }

    /// Renumbers the faces of the vertices from `first` on, which so far were numbered from zero, and so were their vertices.
    pub(super) fn adopt(&mut self, first: usize) {
        let base = TRIPLES_PER_VERTEX * first;
        let vertices = first as u32;
        let edges = edge_of((FACES_PER_VERTEX * first) as u32);
        let moved = |corner: u32| {
            if corner == OUTSIDE {
                OUTSIDE
            } else {
                corner + vertices
            }
        };
        self.triples[base..]
            .par_chunks_mut(2 * STRETCH)
            .for_each(|stretch| {
                for [corners, twins] in stretch.as_chunks_mut().0 {
                    *corners = corners.map(moved);
                    *twins = twins.map(|e| e + edges);
                }
            });
    }

    /// The number of places for faces.
    pub(super) fn len(&self) -> usize {
        self.triples.len() / 2
    }

    /// Puts the triangles at these places, each from its corner of least name, into `triangles`, in no order, and returns
    /// how many there are.
    pub(super) fn triangles(
        &self,
        places: Range<usize>,
        names: &[u32],
        triangles: &mut [Triple],
    ) -> usize {
        let mut found = 0;
        for &[corners, _] in &self.triples.as_chunks().0[places] {
            // A ghost, or a place not in use.
            if corners.contains(&OUTSIDE) || corners[0] == corners[1] {
                continue;
            }
            let [a, b, c] = corners.map(|vertex| names[vertex as usize]);
            triangles[found] = match a.min(b).min(c) {
                least if least == a => [a, b, c],
                least if least == b => [b, c, a],
                _ => [c, a, b],
            };
            found += 1;
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_a_face_follow_each_other() {
        for face in [0, 1, 77] {
            let [a, b, c] = [0, 1, 2].map(|k| edge_of(face) + k);
            assert_eq!([a, b, c].map(next), [b, c, a]);
            assert_eq!([a, b, c].map(prev), [c, a, b]);
        }
    }

    #[test]
    fn ghosts_of_a_hull_are_neighbours() {
        let mut triples = [[0; 3]; 8];
        let mut faces = Faces::new(&mut triples);
        faces.surround(0, [5, 6, 7]);
        let mut out = next(edge_of(0));
        for vertex in [5, 6, 7, 5] {
            assert_eq!(faces.origin(out), vertex);
            assert_eq!(faces.origin(next(out)), OUTSIDE);
            out = faces.twin(next(out));
        }
        let names: Vec<u32> = (0..8).collect();
        assert_eq!(faces.triangles(0..4, &names, &mut []), 0);
    }
}
