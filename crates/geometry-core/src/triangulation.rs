//! A triangulation of a planar point set, as a canonical value.

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
    /// ```
    /// use geometry_core::Triangulation;
    /// let triangulation = Triangulation::new(vec![[2, 3, 0], [1, 2, 0]]);
    /// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3]]);
    /// ```
    pub fn new(mut triangles: Vec<[u32; 3]>) -> Self {
        for corners in &mut triangles {
            let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(first);
        }
        triangles.sort_unstable();
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
