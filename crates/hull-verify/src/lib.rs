//! Proof that a convex hull, in the plane or in space, the convex layers of a planar set, or a Delaunay triangulation
//! is right.
//!
//! # What it proves
//!
//! Each check takes points and a claimed value, and either gives a certificate or says what is wrong. A certificate
//! means that the claimed value is *the* right one: there is one right value for given points, and it is that one
//! (of Delaunay triangulations of cocircular points there are several, and it is one of them).
//!
//! | check | claim | certificate, or findings |
//! |---|---|---|
//! | [`check::hull2`] | [`Hull2`](geometry_core::Hull2) | [`Certificate2`](check::Certificate2), [`Finding`](check::Finding) |
//! | [`check::layers`] | [`Layers`](geometry_core::Layers) | [`LayersCertificate`](check::LayersCertificate), [`Finding`](check::Finding) |
//! | [`check::hull3`] | [`Hull3`](geometry_core::Hull3) | [`Certificate3`](check::Certificate3), [`Finding3`](check::Finding3) |
//! | [`check::delaunay`] | [`Triangulation`](geometry_core::Triangulation) | [`DelaunayCertificate`](check::DelaunayCertificate), [`DelaunayFinding`](check::DelaunayFinding) |
//!
//! # What it assumes
//!
//! Nothing of the algorithms, and no arithmetic of theirs. Coordinates become integers times one power of
//! two ([`arithmetic`]), in code written here and tested against `num-bigint`; no question is put to a kernel
//! of `geometry-core`. From that crate come only the types of points, results and methods. What is left to
//! trust is integer arithmetic, the comparison of two finite `f64` by the machine, and the argument written
//! at the top of [`check`].
//!
//! # The parts
//!
//! | module | holds |
//! |---|---|
//! | [`arithmetic`] | the sides of lines, planes and circles, exactly, for any finite `f64` |
//! | [`check`] | the certificates: O(n log h) in the plane, a walk a point in space |
//! | [`oracle`] | hulls and layers straight from the definition: O(n² h) in the plane, O(n⁴) in space |
//! | [`families`], [`families_space`] | the degenerate point sets of the plane and of space, by name |
//! | [`conformance`] | the whole suite for any method, in one line |
//!
//! # Example
//!
//! ```
//! use geometry_core::{Boundary, Hull2};
//! use hull_verify::check::{self, Finding};
//!
//! let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
//! let certificate = check::hull2(&points, Boundary::Extreme, &Hull2::Polygon(vec![0, 1, 2, 3])).unwrap();
//! assert_eq!((certificate.n, certificate.h), (5, 4));
//!
//! let findings = check::hull2(&points, Boundary::Extreme, &Hull2::Polygon(vec![0, 1, 2])).unwrap_err();
//! assert_eq!(findings, [Finding::Outside { point: 3, from: 2, to: 0 }]);
//! assert_eq!(findings[0].to_string(), "point 3 lies outside edge 2 -> 0");
//! ```

pub mod arithmetic;
pub mod check;
pub mod conformance;
pub mod families;
pub mod families_space;
pub mod oracle;
