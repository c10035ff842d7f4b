//! The studies: each takes what it runs on and adds rows to the records.
//!
//! | module | does |
//! |---|---|
//! | [`peels`] | complete peelings |
//! | [`tolerance`] | the sweep of Table 1 |

pub(crate) mod peels;
pub(crate) mod tolerance;

use anyhow::{Context, Result, bail};
use geometry_core::Task;
use geometry_core::method::{PlanarHull, PlanarLayers};

/// The hull method registered as `slug`.
pub(crate) fn hull_method(slug: &str) -> Result<PlanarHull> {
    match hullkit::method(slug)
        .with_context(|| format!("no method is registered as {slug:?}"))?
        .task
    {
        Task::PlanarHull(task) => Ok(task),
        _ => bail!("the method {slug:?} does not compute a planar hull"),
    }
}

/// The layers method registered as `slug`.
pub(crate) fn layers_method(slug: &str) -> Result<PlanarLayers> {
    match hullkit::method(slug)
        .with_context(|| format!("no method is registered as {slug:?}"))?
        .task
    {
        Task::PlanarLayers(task) => Ok(task),
        _ => bail!("the method {slug:?} does not compute planar layers"),
    }
}
