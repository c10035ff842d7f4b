//! A computation with its options: a method by name, a convention, a number of processors.

use crate::space::hull_3d_parallel;
use crate::{Boundary, Hull2, Hull3, HullError, Layers, Method, Points, Task, Triangulation};
use std::fmt;

/// How many processors may take part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Processors {
    /// One.
    #[default]
    One,
    /// As many as the current rayon thread pool has.
    Pool,
}

/// What is to be computed, and how. The result is the same value whatever the method and the processors.
///
/// ```
/// use hullkit::{Boundary, Builder, Processors};
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
///
/// let hull = Builder::new().method("gs")?.boundary(Boundary::All).convex_hull_2d(&points)?;
/// assert_eq!(hull.vertices(), [0, 2, 1, 3, 4]);
///
/// let hull = Builder::new().processors(Processors::Pool).convex_hull_2d(&points)?;
/// assert_eq!(hull, hullkit::convex_hull_2d(&points)?);
///
/// assert!(Builder::new().method("no-such-method").is_err());
/// # Ok::<(), hullkit::BuildError>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Builder {
    method: Option<&'static Method>,
    boundary: Boundary,
    processors: Processors,
}

/// Why nothing was computed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BuildError {
    /// No method has this name.
    UnknownMethod {
        /// The name.
        slug: String,
    },
    /// The method computes something else.
    OtherTask {
        /// The method.
        slug: &'static str,
        /// What was asked for.
        asked: &'static str,
    },
    /// A method that is named runs on one processor.
    OneProcessor {
        /// The method.
        slug: &'static str,
    },
    /// In space, and in a triangulation, there is but one convention.
    OneConvention,
    /// The points or the computation are at fault.
    Hull(HullError),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::UnknownMethod { slug } => write!(f, "no method is called '{slug}'"),
            BuildError::OtherTask { slug, asked } => write!(f, "'{slug}' does not compute {asked}"),
            BuildError::OneProcessor { slug } => {
                write!(f, "'{slug}' runs on one processor; name no method for more")
            }
            BuildError::OneConvention => {
                f.write_str("which boundary points are vertices can be chosen in the plane only")
            }
            BuildError::Hull(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for BuildError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            BuildError::Hull(error) => Some(error),
            _ => None,
        }
    }
}

impl From<HullError> for BuildError {
    fn from(error: HullError) -> Self {
        BuildError::Hull(error)
    }
}

impl Builder {
    /// The method that is fastest for the points, extreme points only, one processor.
    pub fn new() -> Self {
        Self::default()
    }

    /// By the method registered as `slug`; see [`methods`](crate::methods).
    ///
    /// # Errors
    ///
    /// [`BuildError::UnknownMethod`].
    pub fn method(self, slug: &str) -> Result<Self, BuildError> {
        let method = crate::method(slug).ok_or_else(|| BuildError::UnknownMethod {
            slug: slug.to_owned(),
        })?;
        Ok(Self {
            method: Some(method),
            ..self
        })
    }

    /// With these boundary points as vertices.
    #[must_use]
    pub fn boundary(self, boundary: Boundary) -> Self {
        Self { boundary, ..self }
    }

    /// On so many processors. Only the methods that are chosen where none is named run on more than one; layers are
    /// peeled on one whatever is asked for.
    #[must_use]
    pub fn processors(self, processors: Processors) -> Self {
        Self { processors, ..self }
    }

    /// The convex hull of points of the plane, as [`convex_hull_2d`](crate::convex_hull_2d).
    ///
    /// # Errors
    ///
    /// [`BuildError`]: a method of another task, a coordinate that is not finite.
    pub fn convex_hull_2d(&self, points: &[[f64; 2]]) -> Result<Hull2, BuildError> {
        Ok(match (self.named()?, self.processors) {
            (None, Processors::One) => crate::convex_hull_2d_with(points, self.boundary)?,
            (None, Processors::Pool) => crate::convex_hull_2d_parallel(points, self.boundary)?,
            (Some(method), _) => match method.task {
                Task::PlanarHull(task) => (task.exact)(Points::new(points)?, self.boundary)?,
                _ => return Err(other(method, "hulls of points of the plane")),
            },
        })
    }

    /// The convex layers of points of the plane, as [`convex_layers`](crate::convex_layers).
    ///
    /// # Errors
    ///
    /// As [`Builder::convex_hull_2d`].
    pub fn convex_layers(&self, points: &[[f64; 2]]) -> Result<Layers, BuildError> {
        Ok(match self.named()? {
            None => crate::convex_layers(points, self.boundary)?,
            Some(method) => match method.task {
                Task::PlanarLayers(task) => (task.exact)(Points::new(points)?, self.boundary)?,
                _ => return Err(other(method, "layers")),
            },
        })
    }

    /// The convex hull of points of space, as [`convex_hull_3d`](crate::convex_hull_3d).
    ///
    /// # Errors
    ///
    /// As [`Builder::convex_hull_2d`]; [`BuildError::OneConvention`] for all boundary points.
    pub fn convex_hull_3d(&self, points: &[[f64; 3]]) -> Result<Hull3, BuildError> {
        self.extreme_only()?;
        Ok(match (self.named()?, self.processors) {
            (None, Processors::One) => crate::convex_hull_3d(points)?,
            (None, Processors::Pool) => hull_3d_parallel(points)?,
            (Some(method), _) => match method.task {
                Task::SpatialHull(task) => (task.exact)(Points::new(points)?)?,
                _ => return Err(other(method, "hulls of points of space")),
            },
        })
    }

    /// The Delaunay triangulation of points of the plane, as [`delaunay`](crate::delaunay()).
    ///
    /// # Errors
    ///
    /// As [`Builder::convex_hull_3d`].
    pub fn delaunay(&self, points: &[[f64; 2]]) -> Result<Triangulation, BuildError> {
        self.extreme_only()?;
        Ok(match (self.named()?, self.processors) {
            (None, Processors::One) => crate::delaunay(points)?,
            (None, Processors::Pool) => {
                lifted_delaunay::fast_delaunay_parallel(Points::new(points)?)?
            }
            (Some(method), _) => match method.task {
                Task::Delaunay(task) => (task.exact)(Points::new(points)?)?,
                _ => return Err(other(method, "triangulations")),
            },
        })
    }

    /// The method that is named, if it runs on as many processors as are asked for.
    fn named(&self) -> Result<Option<&'static Method>, BuildError> {
        match (self.method, self.processors) {
            (Some(method), Processors::Pool) => Err(BuildError::OneProcessor { slug: method.slug }),
            (method, _) => Ok(method),
        }
    }

    fn extreme_only(&self) -> Result<(), BuildError> {
        match self.boundary {
            Boundary::Extreme => Ok(()),
            Boundary::All => Err(BuildError::OneConvention),
        }
    }
}

fn other(method: &Method, asked: &'static str) -> BuildError {
    BuildError::OtherTask {
        slug: method.slug,
        asked,
    }
}
