//! A registered method run once more with every question counted and every step tallied.

use geometry_core::{
    Boundary, Counted, Exact, HullError, Point2, Point3, Points, QuestionCounts, StageCounts,
    Tally, Task, method::Delaunay,
};
use std::collections::BTreeMap;

/// Exact integers by name: the same on every machine.
pub(crate) type Counters = BTreeMap<&'static str, u64>;

/// Points of the plane or of space.
#[derive(Clone, Debug, PartialEq)]
pub enum PointSet {
    /// Points of the plane
    Plane(Vec<[f64; 2]>),
    /// Points of space
    Space(Vec<[f64; 3]>),
}

impl PointSet {
    /// How many coordinates a point has.
    pub fn dimension(&self) -> usize {
        match self {
            PointSet::Plane(_) => 2,
            PointSet::Space(_) => 3,
        }
    }

    /// The coordinates, point by point.
    pub fn coordinates(&self) -> &[f64] {
        match self {
            PointSet::Plane(points) => points.as_flattened(),
            PointSet::Space(points) => points.as_flattened(),
        }
    }
}

/// What `task` asks and does on `points`, the whole call with its set-up; `None` where a method has no counted instance
/// or the points are not of its dimension. Counters that are zero are left out.
///
/// # Errors
///
/// Those of the method.
pub(crate) fn count(task: Task, points: &PointSet) -> Result<Option<Counters>, HullError> {
    match points {
        PointSet::Plane(points) => count_in_plane(task, points, Boundary::Extreme),
        PointSet::Space(points) => count_in_space(task, points),
    }
}

/// [`count`], of points of the plane.
pub(crate) fn count_in_plane(
    task: Task,
    points: &[Point2],
    boundary: Boundary,
) -> Result<Option<Counters>, HullError> {
    let points = Points::new(points)?;
    let (kernel, mut tally) = (Counted::new(Exact), Tally::default());
    let asked = match task {
        Task::PlanarHull(hull) => {
            (hull.tallied)(points, boundary, &kernel, &mut tally)?;
            kernel.counts()
        }
        Task::PlanarLayers(layers) => {
            (layers.tallied)(points, boundary, &kernel, &mut tally)?;
            kernel.counts()
        }
        Task::Delaunay(Delaunay {
            counted: Some(counted),
            ..
        }) => counted(points)?.1,
        _ => return Ok(None),
    };
    Ok(Some(counters(&asked, &tally)))
}

/// [`count`], of points of space.
pub(crate) fn count_in_space(task: Task, points: &[Point3]) -> Result<Option<Counters>, HullError> {
    let Task::SpatialHull(hull) = task else {
        return Ok(None);
    };
    let (kernel, mut tally) = (Counted::new(Exact), Tally::default());
    (hull.tallied)(Points::new(points)?, &kernel, &mut tally)?;
    Ok(Some(counters(&kernel.counts(), &tally)))
}

/// The counters that are not zero.
pub(crate) fn counters(asked: &QuestionCounts, tally: &Tally) -> Counters {
    let beyond = |stages: StageCounts| stages.adaptive + stages.integer;
    let staged = [
        (
            "orientations",
            "orientations-beyond-filter",
            asked.orientations,
        ),
        ("distances", "distances-beyond-filter", asked.distances),
        ("in-circles", "in-circles-beyond-filter", asked.in_circles),
        (
            "orientations-in-space",
            "orientations-in-space-beyond-filter",
            asked.orientations_in_space,
        ),
        ("heights", "heights-beyond-filter", asked.heights),
        ("shadows", "shadows-beyond-filter", asked.shadows),
    ];
    let plain = [
        ("along", asked.along),
        ("lexicographic", asked.lexicographic),
        ("angles", asked.angles),
        ("visits", tally.visits),
        ("lines", tally.lines),
        ("apexes", tally.apexes),
        ("edges", tally.edges),
        ("pushes", tally.pushes),
        ("pops", tally.pops),
        ("discards", tally.discards),
        ("inserts", tally.inserts),
        ("bridges", tally.bridges),
        ("merges", tally.merges),
        ("facets", tally.facets),
        ("drops", tally.drops),
        ("candidates", tally.candidates),
        ("layers", tally.layers),
        ("storage", tally.storage),
    ];
    let staged = staged
        .into_iter()
        .flat_map(|(all, hard, stages)| [(all, stages.total()), (hard, beyond(stages))]);
    staged
        .chain(plain)
        .filter(|(_, value)| *value > 0)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_count_is_the_same_each_time_and_fits_the_dimension() {
        let square = PointSet::Plane(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let gs = hullkit::method("gs").expect("a method").task;
        let counted = count(gs, &square).expect("a hull").expect("counted");
        assert!(counted["orientations"] > 0 && !counted.contains_key("heights"));
        assert_eq!(count(gs, &square).expect("a hull"), Some(counted));
        let quickhull = hullkit::method("quickhull-3d").expect("a method").task;
        assert_eq!(count(quickhull, &square).expect("no hull"), None);
    }
}
