//! Hulls by gift wrapping, after Jarvis.

use geometry_core::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
