//! Quickhull in its historical and modern forms.

use geometry_core::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
