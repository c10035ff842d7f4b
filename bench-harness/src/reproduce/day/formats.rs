//! The number formats by name, with Day's merge in each.

use anyhow::{Context, Result};
use divide_and_conquer::preparata_hong_3d::cotangent::{Failure, day_cotangent};
use geometry_core::tolerance::formats::{
    Cdc7600, Double, Extended, Format, IbmShort, Single,
};
use geometry_core::{Point3, Points};

/// Facets, or why there are none.
pub(crate) type Facets = Result<Vec<[u32; 3]>, Failure>;

/// A format, and Day's merge in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Machine {
    pub(crate) name: &'static str,
    /// The facets that Day's program finds with an eps2.
    pub(crate) facets: fn(Points<'_, 3>, f64) -> Facets,
    /// The points as the format holds them.
    pub(crate) rounded: fn(&[Point3]) -> Vec<Point3>,
}

/// The format called `name`.
pub(crate) fn find(name: &str) -> Result<Machine> {
    let all = [
        machine::<Single>(),
        machine::<Double>(),
        machine::<Extended>(),
        machine::<Cdc7600>(),
        machine::<IbmShort>(),
    ];
    all.into_iter()
        .find(|machine| machine.name == name)
        .with_context(|| format!("no number format is called {name:?}"))
}

fn machine<F: Format>() -> Machine {
    Machine {
        name: F::NAME,
        facets: day_cotangent::<F>,
        rounded: |points| {
            let round = |point: &Point3| point.map(|coordinate| F::of(coordinate).to_f64());
            points.iter().map(round).collect()
        },
    }
}
