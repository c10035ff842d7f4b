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
//! | [`targets`] | whether the fast methods take no longer than they are meant to |
//! | [`published`] | times that the authors of other programs print, beside the same programs here |
//! | [`claims`] | the verdicts on the papers' claims |
//! | [`export`] | a run for other tools |
//!
//! [`input`] says where points come from, [`select`] which method runs, [`claim`] reads the hulls of others, [`recorded`]
//! loads runs, `known` the small tables that are built in.

pub mod check;
pub mod claim;
pub mod claims;
pub mod cmp;
pub mod delaunay;
pub mod diff;
pub mod engine;
pub mod export;
pub mod fit;
pub mod hull;
pub mod input;
mod known;
pub mod methods;
pub mod peel;
pub mod peers;
pub mod plot;
pub mod points;
pub mod published;
pub mod rank;
pub mod recorded;
pub mod report;
pub mod select;
pub mod sweep;
pub mod table;
pub mod targets;
