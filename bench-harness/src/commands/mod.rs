//! The subcommands on a user's own points.
//!
//! Each holds its arguments, `Args`, and does its work in `run`, which computes first, certifies, and only
//! then writes.
//!
//! | module | subcommand |
//! |---|---|
//! | [`hull`] | the convex hull of points |
//! | [`peel`] | the convex layers of points |
//! | [`points`] | a point set from the catalogue |
//! | [`methods`] | the registered methods |
//!
//! [`input`] says where points come from, [`select`] which method runs.

pub mod hull;
pub mod input;
pub mod methods;
pub mod peel;
pub mod points;
pub mod select;
