//! What papers on hulls in space share.
//!
//! | module | holds |
//! |---|---|
//! | [`sets`] | point sets of space by (seed, distribution, n, replicate) |
//! | [`certify`](mod@certify) | one hull proved, all other methods' results held against it |
//! | [`count`](mod@count) | a registered method run with every question counted |
//! | [`rows`] | the rows these leave behind |
//! | [`surface`] | whether triangles are the surface of a certified hull |
//! | [`growth`] | exponents of growth, and parts of verdicts about them |
//! | [`times`] | registered methods on the clock, certified first |
//! | [`ratio`] | times of one contestant over another's |
//!
//! The interleaved timing loop is [`super::timing`], the expected numbers of vertices are
//! [`super::theory::hull_size_in_space`].

pub(crate) mod certify;
pub(crate) mod count;
pub(crate) mod growth;
pub(crate) mod ratio;
pub(crate) mod rows;
pub(crate) mod sets;
pub(crate) mod surface;
pub(crate) mod times;

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
