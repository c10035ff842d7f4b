//! The number formats by name, with Day's merge in each, and how a run of it ends.

use super::check;
use crate::reproduce::space::surface::is_hull;
use anyhow::{Context, Result};
use divide_and_conquer::preparata_hong_3d::cotangent::{Failure, Outcome, day_cotangent};
use geometry_core::tolerance::formats::{Cdc7600, Double, Extended, Format, IbmShort, Single};
use geometry_core::{Hull3, Point3, Points};

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
    /// Whether the paper's check, computed in the format, accepts these faces of these points.
    pub(crate) accepts: fn(&[Point3], &[[u32; 3]]) -> bool,
}

impl Machine {
    /// How Day's program ends on `points`, which the format holds and whose certified hull is `hull`, with an eps2 of ten
    /// to the `power`.
    ///
    /// Faces in one plane may come as triangles, as Day has them.
    pub(crate) fn end(&self, points: &[Point3], hull: &Hull3, power: i32) -> Outcome {
        let Ok(view) = Points::new(points) else {
            return Outcome::Dangling;
        };
        match (self.facets)(view, 10_f64.powi(power)) {
            Ok(facets) if is_right(view, &facets, hull) => Outcome::Right,
            Ok(_) => Outcome::WrongHull,
            Err(Failure::NotTerminating) => Outcome::NotTerminating,
            Err(Failure::Dangling | Failure::TooFewPoints) => Outcome::Dangling,
        }
    }
}

/// Whether `facets` are the surface of `hull` and have no dummy point for a corner.
pub(crate) fn is_right(points: Points<'_, 3>, facets: &[[u32; 3]], hull: &Hull3) -> bool {
    let is_given = |id: &u32| (*id as usize) < points.len();
    facets.iter().flatten().all(is_given) && is_hull(points, facets, hull)
}

/// The word for an end in tables.
pub(crate) fn word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Right => "right",
        Outcome::WrongHull => "wrong hull",
        Outcome::NotTerminating => "endless",
        Outcome::Dangling => "dangling",
    }
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
        accepts: check::accepts::<F>,
        rounded: |points| {
            let round = |point: &Point3| point.map(|coordinate| F::of(coordinate).to_f64());
            points.iter().map(round).collect()
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::sets::PointSet3;

    #[test]
    fn a_run_ends_right_wrong_or_not_at_all() {
        let set = PointSet3::generate(1, "cube", 100, 0).expect("a set");
        let ends = |name: &str, power| {
            let machine = find(name).expect("a format");
            let points = (machine.rounded)(&set.points);
            let hull = hullkit::convex_hull_3d(&points).expect("finite");
            machine.end(&points, &hull, power)
        };
        assert_eq!(ends("extended", 16), Outcome::Right);
        assert_eq!(ends("f64", 10), Outcome::Right);
        assert_ne!(ends("f32", 16), Outcome::Right);
        assert!(find("f16").is_err());
    }

    #[test]
    fn a_dummy_for_a_corner_is_wrong() {
        let set = PointSet3::generate(1, "ball", 20, 0).expect("a set");
        let points = Points::new(&set.points).expect("finite");
        let hull = hullkit::convex_hull_3d(&set.points).expect("finite");
        let mut faces: Vec<[u32; 3]> = hull.triangles().collect();
        assert!(is_right(points, &faces, &hull));
        faces[0][1] = 20;
        assert!(!is_right(points, &faces, &hull));
    }
}
