//! Exact expectations that a measured average can be held against.

pub(crate) mod hull_size;
#[allow(
    dead_code,
    reason = "the experiments of the spatial papers, which are next, compare with these"
)]
pub(crate) mod hull_size_in_space;
pub(crate) mod quadrature;
