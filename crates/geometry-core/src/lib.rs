//! What every convex hull algorithm here stands on.
//!
//! An algorithm never compares coordinates by itself: it asks a [`Kernel2`] which side, which is further,
//! which comes first. The kernel decides how the answer is found, so one source of an algorithm runs
//!
//! - with [`Exact`] answers, right for every finite `f64`;
//! - with a paper's own arithmetic and tolerance, [`Tolerance`];
//! - with every question [`Counted`], or with ties broken by [`Perturbed`].
//!
//! # The parts
//!
//! | module | holds |
//! |---|---|
//! | [`points`] | [`Points`], the validated view of the caller's slice |
//! | [`sign`] | [`Sign`], the answer to an orientation question |
//! | [`kernel`] | the questions ([`Kernel2`], [`InCircle`], [`Kernel3`]) and the decorators |
//! | [`exact`] | the exact answers: filter, adaptive expansions, scaled integers |
//! | [`tolerance`] | the answers of 1979: areas below an epsilon are zero, in five number formats |
//! | [`hull2`], [`hull3`], [`layers`], [`triangulation`] | canonical results, equal (`==`) exactly when the geometry is equal |
//! | [`dimension`] | the affine dimension of a set in space, and the way down to the plane |
//! | [`mesh`] | the triangulated surface that spatial algorithms grow |
//! | [`sort`] | a sort that no comparison can upset |
//! | [`observer`] | hooks for counting and teaching that cost nothing when off |
//! | [`method`] | the registry entry of an algorithm |
//!
//! # Conventions
//!
//! Points are `[f64; 2]` and `[f64; 3]`; results are `u32` indices into the caller's slice. Positive
//! orientation is anticlockwise, with x to the right and y up. Polygons run anticlockwise from their
//! lexicographically smallest vertex.

pub mod dimension;
mod dyadic;
pub mod error;
pub mod exact;
pub mod hull2;
pub mod hull3;
pub mod kernel;
pub mod layers;
pub mod mesh;
pub mod method;
pub mod observer;
pub mod points;
pub mod sign;
pub mod sort;
pub mod tolerance;
pub mod triangulation;

pub use error::HullError;
pub use exact::Exact;
pub use hull2::{Boundary, Hull2};
pub use hull3::{Edges, Hull3, Solid};
pub use kernel::counted::{Counted, QuestionCounts, StageCounts};
pub use kernel::lifted::Lifted;
pub use kernel::perturbed::Perturbed;
pub use kernel::space::{Axis, Basis, Kernel3};
pub use kernel::{InCircle, Kernel2, Stage};
pub use layers::Layers;
pub use method::{Method, Task};
pub use observer::{Observer, Recorder, Silent, Step, Tally};
pub use points::{Point2, Point3, Points};
pub use sign::Sign;
pub use tolerance::Tolerance;
pub use triangulation::Triangulation;
