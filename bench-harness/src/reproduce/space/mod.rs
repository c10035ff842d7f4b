//! What papers on hulls in space share.
//!
//! | module | holds |
//! |---|---|
//! | [`certify`](mod@certify) | one hull proved, all other methods' results held against it |
//! | [`count`](mod@count) | the row of a counted run |
//! | [`surface`] | whether triangles are the surface of a certified hull |
//! | [`growth`] | exponents of growth, and parts of verdicts about them |
//!
//! The interleaved timing loop is [`super::timing`], the expected numbers of vertices are
//! [`super::theory::hull_size_in_space`].

pub(crate) mod certify;
pub(crate) mod count;
pub(crate) mod growth;
pub(crate) mod surface;

use anyhow::{Context, Result, bail};
use geometry_core::Task;
use geometry_core::method::SpatialHull;

/// The method for hulls in space registered as `slug`.
pub(crate) fn spatial_method(slug: &str) -> Result<SpatialHull> {
    match hullkit::method(slug)
        .with_context(|| format!("no method is registered as {slug:?}"))?
        .task
    {
        Task::SpatialHull(task) => Ok(task),
        _ => bail!("the method {slug:?} does not compute hulls in space"),
    }
}
