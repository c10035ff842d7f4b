//! Hulls by inserting one point at a time.

use geometry_core::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
