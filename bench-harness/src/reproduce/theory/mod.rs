//! Exact expectations that a measured average can be held against.

pub(crate) mod hull_size;
pub(crate) mod quadrature;
