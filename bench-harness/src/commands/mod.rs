//! The subcommands on a user's own points.
//!
//! Each holds its arguments, `Args`, and does its work in `run`, which computes first, certifies, and only
//! then writes.
//!
//! | module | subcommand |
//! |---|---|
//! | [`hull`] | the convex hull of points of the plane or of space |
//! | [`peel`] | the convex layers of points |
//! | [`delaunay`] | the Delaunay triangulation of points |
//! | [`sweep`] | the volume swept by a part |
//! | [`check`] | whether a hull made by anyone is the hull of the points |
//! | [`points`] | a point set from the catalogue |
//! | [`methods`] | the registered methods |
//! | [`engine`] | one of our methods, answering the pipe protocol |
//! | [`peers`] | outside programs, built and asked who they are |
//!
//! [`input`] says where points come from, [`select`] which method runs, [`claim`] reads the hulls of others.

pub mod check;
pub mod claim;
pub mod delaunay;
pub mod engine;
pub mod hull;
pub mod input;
pub mod methods;
pub mod peel;
pub mod peers;
pub mod points;
pub mod select;
pub mod sweep;
