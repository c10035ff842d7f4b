//! A triangulation of a planar point set, as a canonical value.

pub mod order;

use order::{Dealt, Keys};

/// Up to as many triangles are sorted by comparisons alone.
const FEW: usize = 64;

/// A triangulation of points of the plane.
///
/// Canonical: each triangle is anticlockwise and begins with its smallest index, and the triangles are in
/// lexicographic order, so two equal triangulations are equal values.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Triangulation {
    triangles: Vec<[u32; 3]>,
}

impl Triangulation {
    /// The triangulation with these anticlockwise triangles, in any order, each starting anywhere.
    ///
    /// # Cost
    ///
    /// Linear where indices are dense and few triangles share a smallest corner, as those of triangulations by any
    /// method are; O(t log t) for t triangles at worst.
    ///
    /// ```
    /// use geometry_core::Triangulation;
    /// let triangulation = Triangulation::new(vec![[2, 3, 0], [1, 2, 0]]);
    /// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3]]);
    /// ```
    pub fn new(mut triangles: Vec<[u32; 3]>) -> Self {
        let Some(keys) = keys_of(&mut triangles) else {
            triangles.sort_unstable();
            return Self { triangles };
        };
        let mut room = vec![[0; 3]; triangles.len()];
        let dealt = Dealt::of(&triangles, keys, &mut room);
        keys.sort(&[dealt], &mut triangles);
        Self { triangles }
    }

    /// [`new`](Self::new) of triangles in some memory, of which the triangulation is to be made in other memory that
    /// is not needed any more: it takes longer to get fresh memory than to sort.
    ///
    /// # Cost
    ///
    /// As [`new`](Self::new). What `room` holds does not matter. If it is not twice as long as `triangles`, it is made
    /// so.
    ///
    /// ```
    /// use geometry_core::Triangulation;
    /// let triangulation = Triangulation::in_room(&mut [[2, 3, 0], [1, 2, 0]], vec![[7; 3]; 5]);
    /// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3]]);
    /// ```
    pub fn in_room(triangles: &mut [[u32; 3]], mut room: Vec<[u32; 3]>) -> Self {
        let len = triangles.len();
        let keys = keys_of(triangles);
        if room.len() < 2 * len {
            room.resize(2 * len, [0; 3]);
        }
        let (sorted, others) = room.split_at_mut(len);
        if let Some(keys) = keys {
            let dealt = Dealt::of(triangles, keys, &mut others[..len]);
            keys.sort(&[dealt], sorted);
        } else {
            sorted.copy_from_slice(triangles);
            sorted.sort_unstable();
        }
        room.truncate(len);
        room.shrink_to_fit();
        Self { triangles: room }
    }

    /// The triangulation with these triangles, which must be in [canonical](Triangulation) order.
    ///
    /// ```
    /// use geometry_core::Triangulation;
    /// let triangles = vec![[0, 1, 2], [0, 2, 3]];
    /// assert_eq!(Triangulation::from_canonical(triangles.clone()), Triangulation::new(triangles));
    /// ```
    pub fn from_canonical(triangles: Vec<[u32; 3]>) -> Self {
        debug_assert!(triangles.is_sorted());
        debug_assert!(triangles.iter().all(|&t| smallest_first(t) == t));
        Self { triangles }
    }

    /// The triangles in canonical order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The number of triangles.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle, as for fewer than three points that are not collinear.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Every edge once, smaller index first, in lexicographic order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges: Vec<[u32; 2]> = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The edges on the convex hull: those of one triangle only, directed anticlockwise, in lexicographic order.
    pub fn hull_edges(&self) -> Vec<[u32; 2]> {
        let directed = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut directed: Vec<[u32; 2]> = directed.collect();
        directed.sort_unstable();
        let is_inner = |&[a, b]: &[u32; 2]| directed.binary_search(&[b, a]).is_ok();
        directed
            .iter()
            .copied()
            .filter(|edge| !is_inner(edge))
            .collect()
    }
}

/// Lets each triangle begin with its smallest corner, and returns what they can be sorted by, if they can be sorted by counting.
fn keys_of(triangles: &mut [[u32; 3]]) -> Option<Keys> {
    let mut largest = 0;
    for corners in &mut *triangles {
        *corners = smallest_first(*corners);
        largest = largest.max(corners[0]);
    }
    let keys = Keys::up_to(largest, triangles.len());
    keys.filter(|_| triangles.len() > FEW)
}

/// The same triangle from its smallest corner. Short-circuits nothing, as nothing could predict it.
#[inline(always)]
fn smallest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if (b < a) & (b <= c) {
        [b, c, a]
    } else if (c < a) & (c < b) {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_begins_with_its_smallest_corner_wherever_it_was() {
        for corners in [
            [1, 2, 3],
            [1, 3, 2],
            [2, 1, 3],
            [2, 3, 1],
            [3, 1, 2],
            [3, 2, 1],
        ] {
            let mut expected = corners;
            let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            expected.rotate_left(first);
            assert_eq!(smallest_first(corners), expected, "{corners:?}");
        }
    }

    /// Triangles with every rotation and many equal first corners, by counting and by comparing.
    #[test]
    fn counting_and_comparing_give_the_same_order() {
        for len in [0, 1, FEW, FEW + 1, 40 * FEW] {
            let corner = |i: usize| (i as u32).wrapping_mul(2_654_435_761) >> 20;
            let triangles = (0..len).map(|i| [i, i + len, i + 2 * len].map(corner));
            let canonical = |corners: &[u32; 3]| {
                let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
                [0, 1, 2].map(|i| corners[(first + i) % 3])
            };
            let mut expected: Vec<[u32; 3]> = triangles.clone().map(|t| canonical(&t)).collect();
            expected.sort_unstable();
            let triangulation = Triangulation::new(triangles.collect());
            assert_eq!(triangulation.triangles(), expected);
        }
    }

    #[test]
    fn indices_far_apart_are_sorted_too() {
        let far = u32::MAX - 1;
        let triangles = (0..100).map(|i| [far - i, 7, far - 2 * i]).collect();
        let triangulation = Triangulation::new(triangles);
        assert!(triangulation.triangles().is_sorted());
        assert!(triangulation.triangles().iter().all(|t| t[0] == 7));
    }
}
