//! Point sets to compute hulls of: the papers' distributions, lattices, worst cases, and files.
//!
//! A set is named by a [`Spec`], read from text such as `disc` or `lattice:cols=10,rows=10`. Together with
//! the number of points and a seed it gives the same bits on every machine: the only source of randomness is
//! ChaCha8, every transcendental function comes from the pure-Rust `libm`, and every other operation is
//! correctly rounded. A [`Fingerprint`] names the bits, so a record can say which points it is about.
//!
//! ```
//! use point_sets::{Spec, fingerprint};
//! let spec: Spec = "lattice:cols=10,rows=10".parse()?;
//! let points = spec.generate(100, 1)?;
//! assert_eq!(points[99], [9.0, 9.0]);
//! assert_eq!(fingerprint(&points), fingerprint(&spec.generate(100, 2)?));
//!
//! let ball = "ball".parse::<Spec>()?.generate3(100, 1)?;
//! assert_eq!(ball.len(), 100);
//! # Ok::<(), point_sets::SpecError>(())
//! ```
//!
//! # The parts
//!
//! | module | holds |
//! |---|---|
//! | [`spec`] | [`Spec`]: the name of a set and its parameters, as text and as a value |
//! | [`catalogue`](mod@catalogue) | [`catalogue()`]: every set there is, for lists and for messages |
//! | `sets` | one file a set, each with a sketch |
//! | [`fingerprint`](mod@fingerprint) | [`Fingerprint`]: SHA-256 of the coordinates' bits |
//! | [`seed`] | [`cell_seed`]: the seed of one cell of an experiment |
//! | [`mod@file`] | points in text files, in and out |
//! | [`mesh_file`] | polygon meshes in files: OFF, OBJ, PLY, STL |
//!
//! A new set is one file in `sets` and one line in the catalogue.

pub mod catalogue;
mod draw;
pub mod error;
pub mod file;
pub mod fingerprint;
pub mod mesh_file;
pub mod seed;
mod sets;
pub mod spec;
mod syntax;

pub use catalogue::{Entry, Parameter, catalogue};
pub use error::SpecError;
pub use fingerprint::{Fingerprint, fingerprint};
pub use seed::cell_seed;
pub use spec::Spec;
