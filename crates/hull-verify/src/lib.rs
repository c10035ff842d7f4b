//! Proof that a planar hull, or the convex layers of a planar set, is right.
//!
//! # What it proves
//!
//! [`check::hull2`] takes points, a [`Boundary`](geometry_core::Boundary) and a claimed
//! [`Hull2`](geometry_core::Hull2) and either gives a [`Certificate2`](check::Certificate2) or says what is
//! wrong ([`Finding`](check::Finding)). A certificate means that the claimed value is *the* hull: there is
//! one right value for given points and boundary, and it is that one. [`check::layers`] does the same for
//! convex layers.
//!
//! # What it assumes
//!
//! Nothing of the algorithms, and no arithmetic of theirs. Coordinates become integers times one power of
//! two ([`arithmetic`]), in code written here and tested against `num-bigint`; no question is put to a kernel
//! of `geometry-core`. From that crate come only the types of points, hulls, layers and methods. What is left to
//! trust is integer arithmetic, the comparison of two finite `f64` by the machine, and the argument written
//! at the top of [`check`].
//!
//! # The parts
//!
//! | module | holds |
//! |---|---|
//! | [`arithmetic`] | the side of a line, exactly, for any finite `f64` |
//! | [`check`] | the certificate, in O(n log h) |
//! | [`oracle`] | hulls and layers straight from the definition, in O(n² h) |
//! | [`families`] | the degenerate point sets of the plane, by name |
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
