//! hullbench.
fn main() {}
