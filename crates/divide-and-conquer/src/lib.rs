//! Hulls by merging the hulls of two halves, after Preparata and Hong.

use geometry_core::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
