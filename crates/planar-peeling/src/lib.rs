//! Green and Silverman's hull and peels, Graham's scan, Andrew's monotone chain.

use geometry_core::Method;

/// The methods of this family.
pub const METHODS: &[Method] = &[];
