//! The subcommands on a user's own points, and on recorded runs.
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
//! | [`cmp`] | the engines of a run side by side |
//! | [`rank`] | the engines of a run over all cases |
//! | [`diff`] | what has changed between two runs |
//! | [`fit`] | by which law a cost grows |
//! | [`table`] | a run in the layout of a paper |
//! | [`plot`] | a run as drawings |
//! | [`report`] | a run as one HTML file |
//! | [`export`] | a run for other tools |
//!
//! [`input`] says where points come from, [`select`] which method runs, [`claim`] reads the hulls of others, [`recorded`]
//! loads runs.

pub mod check;
pub mod claim;
pub mod cmp;
pub mod delaunay;
pub mod diff;
pub mod engine;
pub mod export;
pub mod fit;
pub mod hull;
pub mod input;
pub mod methods;
pub mod peel;
pub mod peers;
pub mod plot;
pub mod points;
pub mod rank;
pub mod recorded;
pub mod report;
pub mod select;
pub mod sweep;
pub mod table;
