//! Triangles inside triangles, exact integers from the outside in.
//!
//! ```text
//!                ·
//!               / \
//!              / · \         k (0, 1), k (-1, -1), k (1, -1)  for k = ceil(n/3), ..., 2, 1
//!             / / \ \
//!            / ·---· \       every triangle lies strictly inside the one before
//!           ·---------·
//! ```
//!
//! ceil(n/3) convex layers, the most that points can have: the worst case of peeling by repeated hulls. If n
//! is no multiple of 3 the innermost layer has one or two points.

use crate::catalogue::{Entry, Generate};

pub(crate) const ENTRY: Entry = Entry {
    name: "nested-triangles",
    summary: "nested triangles: ceil(n/3) convex layers, the most there can be",
    parameters: &[],
    source: "the worst case of repeated hulls",
    generate: Generate::Plane(|_, n, _| {
        let scales = (1..=n.div_ceil(3)).rev().map(|k| k as f64);
        let corners = scales.flat_map(|k| [[0.0, k], [-k, -k], [k, -k]]);
        Ok(corners.take(n).collect())
    }),
};
