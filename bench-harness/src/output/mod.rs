//! How results leave the program.
//!
//! Results go to standard output or to a file; everything else goes to standard error. A file appears whole
//! or not at all.
//!
//! | module | holds |
//! |---|---|
//! | [`target`] | where a result goes, in which format, and the one way to write it there |
//! | [`atomic`] | files that appear whole or not at all |
//! | [`rows`] | vertices and points as rows of CSV and JSON |
//! | [`hull`], [`hull3`], [`peel`], [`delaunay`], [`sweep`], [`methods`], [`peers`], [`catalogue`] | each result as CSV, JSON or a summary for reading |
//! | [`mesh`] | hulls and triangulations as polygon meshes |
//! | [`drawing`] | a triangulation as an SVG drawing |
//! | [`text`] | the pieces of a summary |
//! | [`sheet`], [`page`] | tables as Markdown, CSV and LaTeX; several under one title, with notes |
//! | [`plot`] | charts as SVG |

pub mod atomic;
pub mod catalogue;
pub mod delaunay;
pub mod drawing;
pub mod hull;
pub mod hull3;
pub mod mesh;
pub mod methods;
pub mod page;
pub mod peel;
pub mod peers;
pub mod plot;
pub mod rows;
pub mod sheet;
pub mod sweep;
pub mod target;
pub mod text;
