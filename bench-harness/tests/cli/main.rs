//! The `hullbench` program as its users meet it: streams, exit codes, files.

mod failures;
mod hull;
mod lists;
mod peel;
mod workshop;
