//! The `hullbench` program as its users meet it: streams, exit codes, files.

mod check;
mod delaunay;
mod failures;
mod hull;
mod lists;
#[path = "../analysis/made_up.rs"]
mod made_up;
mod peel;
mod recorded;
mod space;
mod sweep;
mod workshop;
