//! The registry entry of an algorithm.
//!
//! Lists, tables, tests, traces and documentation iterate over entries; a new algorithm is one file and one
//! entry in its crate's `METHODS`.

use crate::QuestionCounts;
use crate::error::HullError;
use crate::hull2::{Boundary, Hull2};
use crate::hull3::Hull3;
use crate::kernel::Kernel2;
use crate::kernel::space::Kernel3;
use crate::layers::Layers;
use crate::observer::{Recorder, Tally};
use crate::points::Points;
use crate::triangulation::Triangulation;

/// An algorithm: what it is, what it promises, and how to run it.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// The name it is called by on the command line, in tables and in `data/`.
    pub slug: &'static str,
    /// Its name in the literature.
    pub title: &'static str,
    /// Who published it, where and when.
    pub citation: &'static str,
    /// Where it departs from the publication, and why; empty if nowhere.
    pub departures: &'static [&'static str],
    /// The promised cost in time, for n points and h vertices.
    pub cost: &'static str,
    /// What it computes, and the functions that do.
    pub task: Task,
}

/// What a method computes.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Task {
    /// The convex hull of points of the plane.
    PlanarHull(PlanarHull),
    /// The convex layers of points of the plane.
    PlanarLayers(PlanarLayers),
    /// The convex hull of points of space.
    SpatialHull(SpatialHull),
    /// The Delaunay triangulation of points of the plane.
    Delaunay(Delaunay),
}

/// The ways to run a method, each an instance of one generic source.
macro_rules! entry {
    ($(#[$doc:meta])* $name:ident, $dimension:literal $(, $option:ty)?; $kernel:path, $result:ty) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name {
            /// From points that nobody has looked at, with the exact kernel, unobserved: what a user pays, and what is
            /// timed.
            pub unseen: fn(&[[f64; $dimension]] $(, $option)?) -> Result<$result, HullError>,
            /// With the exact kernel, unobserved.
            pub exact: fn(Points<'_, $dimension> $(, $option)?) -> Result<$result, HullError>,
            /// With any kernel, steps tallied: the instance for counts and for historical arithmetic.
            pub tallied: fn(Points<'_, $dimension> $(, $option)?, &dyn $kernel, &mut Tally) -> Result<$result, HullError>,
            /// With any kernel, every step recorded: the instance for teaching.
            pub recorded: fn(Points<'_, $dimension> $(, $option)?, &dyn $kernel, &mut Recorder) -> Result<$result, HullError>,
        }
    };
}

entry!(
    /// The instances of a planar hull method.
    PlanarHull, 2, Boundary; Kernel2, Hull2
);
entry!(
    /// The instances of a planar layers method.
    PlanarLayers, 2, Boundary; Kernel2, Layers
);
entry!(
    /// The instances of a spatial hull method.
    SpatialHull, 3; Kernel3, Hull3
);

/// The instance of a Delaunay method.
#[derive(Clone, Copy, Debug)]
pub struct Delaunay {
    /// From points that nobody has looked at, with the exact kernel: what a user pays, and what is timed.
    pub unseen: fn(&[[f64; 2]]) -> Result<Triangulation, HullError>,
    /// With the exact kernel, unobserved.
    pub exact: fn(Points<'_, 2>) -> Result<Triangulation, HullError>,
    /// With the exact kernel, questions counted; none if the method has no such instance.
    pub counted: Option<CountedDelaunay>,
}

/// A Delaunay method that counts what it asks.
pub type CountedDelaunay = fn(Points<'_, 2>) -> Result<(Triangulation, QuestionCounts), HullError>;

/// The [`Task`] of a generic function
/// `fn<K: Kernel2, O: Observer>(Points<'_, 2>, Boundary, &K, &mut O) -> Result<R, HullError>`:
/// `planar_task!(PlanarHull, my_hull)` for `R = Hull2`, `planar_task!(PlanarLayers, my_layers)` for `R = Layers`.
///
/// A third argument, `fn(&[Point2], Boundary) -> Result<R, HullError>`, is a way to the same value from points that nobody
/// has looked at which is shorter than checking them first.
#[macro_export]
macro_rules! planar_task {
    ($kind:ident, $function:path) => {
        $crate::planar_task!($kind, $function, |points, boundary| {
            let points = $crate::Points::new(points)?;
            $function(points, boundary, &$crate::Exact, &mut $crate::Silent)
        })
    };
    ($kind:ident, $function:path, $unseen:expr) => {
        $crate::method::Task::$kind($crate::method::$kind {
            unseen: $unseen,
            exact: |points, boundary| {
                $function(points, boundary, &$crate::Exact, &mut $crate::Silent)
            },
            tallied: |points, boundary, kernel, tally| $function(points, boundary, &kernel, tally),
            recorded: |points, boundary, kernel, recorder| {
                $function(points, boundary, &kernel, recorder)
            },
        })
    };
}

/// The [`Task`] of a generic function
/// `fn<K: Kernel3, O: Observer>(Points<'_, 3>, &K, &mut O) -> Result<Hull3, HullError>`.
#[macro_export]
macro_rules! spatial_task {
    ($function:path) => {
        $crate::spatial_task!($function, |points| {
            let points = $crate::Points::new(points)?;
            $function(points, &$crate::Exact, &mut $crate::Silent)
        })
    };
    ($function:path, $unseen:expr) => {
        $crate::method::Task::SpatialHull($crate::method::SpatialHull {
            unseen: $unseen,
            exact: |points| $function(points, &$crate::Exact, &mut $crate::Silent),
            tallied: |points, kernel, tally| $function(points, &kernel, tally),
            recorded: |points, kernel, recorder| $function(points, &kernel, recorder),
        })
    };
}

/// The [`Task`] of a function `fn(Points<'_, 2>) -> Result<Triangulation, HullError>`; a second argument is a
/// [`CountedDelaunay`] that asks the same.
#[macro_export]
macro_rules! delaunay_task {
    ($function:path) => {
        $crate::delaunay_task!(@ $function, None)
    };
    ($function:path, $counted:path) => {
        $crate::delaunay_task!(@ $function, Some($counted))
    };
    (@ $function:path, $counted:expr) => {
        $crate::method::Task::Delaunay($crate::method::Delaunay {
            unseen: |points| $function($crate::Points::new(points)?),
            exact: $function,
            counted: $counted,
        })
    };
}
