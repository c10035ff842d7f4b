//! The `hullbench` program as its users meet it: streams, exit codes, files.

mod check;
mod delaunay;
mod failures;
mod hull;
mod lists;
mod peel;
mod space;
mod sweep;
mod workshop;
