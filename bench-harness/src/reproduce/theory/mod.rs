//! Exact expectations that a measured average can be held against.

pub(crate) mod hull_size;
pub(crate) mod hull_size_in_space;
pub(crate) mod quadrature;
