//! The suite itself: it passes a right method, and catches wrong ones.

use geometry_core::{
    Boundary, Hull2, HullError, Kernel2, Layers, Method, Observer, Point2, Points, planar_task,
};
use hull_verify::arithmetic::{Frame, Turn, order};
use hull_verify::conformance;
use hull_verify::families::magnitudes;

fn method(slug: &'static str, task: geometry_core::Task) -> Method {
    Method {
        slug,
        title: "a method for testing the suite",
        citation: "",
        departures: &[],
        cost: "",
        task,
    }
}

type Answer<A> = Result<A, HullError>;

/// Andrew's monotone chain in the checker's arithmetic, of the points `ids`.
fn chain(points: &[Point2], mut ids: Vec<u32>, boundary: Boundary) -> Hull2 {
    let frame = Frame::of(points);
    let at = |id: u32| points[id as usize];
    ids.sort_by(|&a, &b| order(at(a), at(b)).then(a.cmp(&b)));
    ids.dedup_by(|later, kept| at(*later) == at(*kept));
    match ids[..] {
        [] => return Hull2::Empty,
        [only] => return Hull2::Point(only),
        [first, .., last] => {
            if ids
                .iter()
                .all(|&id| frame.turn(at(first), at(last), at(id)) == Turn::Straight)
            {
                let ends = vec![first, last];
                return Hull2::Segment(if boundary == Boundary::All { ids } else { ends });
            }
        }
    }
    let half = |row: &mut dyn Iterator<Item = u32>| {
        let mut chain: Vec<u32> = Vec::new();
        for id in row {
            while let [.., a, b] = chain[..] {
                match (frame.turn(at(a), at(b), at(id)), boundary) {
                    (Turn::Left, _) | (Turn::Straight, Boundary::All) => break,
                    _ => chain.pop(),
                };
            }
            chain.push(id);
        }
        chain.pop();
        chain
    };
    let mut cycle = half(&mut ids.iter().copied());
    cycle.extend(half(&mut ids.iter().rev().copied()));
    Hull2::Polygon(cycle)
}

fn right_hull<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Hull2> {
    Ok(chain(points.as_slice(), points.ids().collect(), boundary))
}

fn right_layers<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Layers> {
    let (mut rings, mut ranks) = (Vec::new(), vec![0; points.len()]);
    let mut left: Vec<u32> = points.ids().collect();
    while !left.is_empty() {
        let ring = chain(points.as_slice(), left.clone(), boundary);
        let mut places: Vec<Point2> = ring.vertices().iter().map(|&id| points[id]).collect();
        places.sort_by(|&a, &b| order(a, b));
        left.retain(|&id| {
            let removed = places
                .binary_search_by(|&place| order(place, points[id]))
                .is_ok();
            if removed {
                ranks[id as usize] = rings.len() as u32 + 1;
            }
            !removed
        });
        rings.push(ring);
    }
    Ok(Layers::new(rings, ranks))
}

#[test]
fn right_methods_pass() {
    conformance::planar_hull(&method("right-hull", planar_task!(PlanarHull, right_hull)));
    conformance::planar_layers(&method(
        "right-layers",
        planar_task!(PlanarLayers, right_layers),
    ));
}

/// Forgets that of copies the smallest index stands: takes the largest.
fn largest_copies<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Answer<Hull2> {
    let largest = |id: &mut u32| {
        let mut copies = points.ids().filter(|&other| points[other] == points[*id]);
        *id = copies.next_back().unwrap_or(*id);
    };
    let mut hull = right_hull(points, boundary, kernel, observer)?;
    match &mut hull {
        Hull2::Empty => {}
        Hull2::Point(id) => largest(id),
        Hull2::Segment(ids) | Hull2::Polygon(ids) => ids.iter_mut().for_each(largest),
    }
    Ok(hull)
}

/// Right, if the last point is not a vertex on its own.
fn drops_the_last_point<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Hull2> {
    let slice = points.as_slice();
    let kept = points.ids().take(slice.len().max(41) - 1);
    Ok(chain(slice, kept.collect(), boundary))
}

/// Overflows where coordinates are huge.
fn panics_on_huge<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Answer<Hull2> {
    let squares: f64 = points.as_slice().as_flattened().iter().map(|x| x * x).sum();
    assert!(squares.is_finite(), "squares overflow");
    right_hull(points, boundary, kernel, observer)
}

/// Fails on one set, as given.
fn panics_on_one_family<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Answer<Hull2> {
    assert_ne!(points.as_slice(), magnitudes::huge());
    right_hull(points, boundary, kernel, observer)
}

/// Listens to the kernel for as long as it finds a right turn.
fn never_stops<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Answer<Hull2> {
    if let [a, b, c, ..] = *points.as_slice() {
        while kernel.orient(a, b, c) == kernel.orient(b, a, c) && !kernel.orient(a, b, c).is_zero()
        {
        }
    }
    right_hull(points, boundary, kernel, observer)
}

/// Gives all points, in one layer.
fn one_layer<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Layers> {
    let ring = chain(points.as_slice(), points.ids().collect(), boundary);
    let rings = if ring.is_empty() {
        Vec::new()
    } else {
        vec![ring]
    };
    Ok(Layers::new(rings, vec![1; points.len()]))
}

/// The message with which the suite rejects the method.
fn rejection(run: impl FnOnce() + std::panic::UnwindSafe) -> String {
    let panic = std::panic::catch_unwind(run).expect_err("a wrong method passed the suite");
    panic
        .downcast_ref::<String>()
        .expect("the suite panics with a report")
        .clone()
}

fn hull_rejection(slug: &'static str, task: geometry_core::Task) -> String {
    rejection(|| conformance::planar_hull(&method(slug, task)))
}

#[test]
fn wrong_methods_are_rejected_with_a_report() {
    let report = hull_rejection("largest-copies", planar_task!(PlanarHull, largest_copies));
    assert!(report.contains("largest-copies (exact) fails"), "{report}");
    assert!(report.contains("which should stand for it"), "{report}");

    let report = hull_rejection("drops-last", planar_task!(PlanarHull, drops_the_last_point));
    assert!(report.contains("expected Polygon"), "{report}");

    let report = hull_rejection("panics", planar_task!(PlanarHull, panics_on_huge));
    assert!(report.contains("it panicked: squares overflow"), "{report}");

    let report = hull_rejection("never-stops", planar_task!(PlanarHull, never_stops));
    assert!(report.contains("the method does not stop"), "{report}");

    let task = planar_task!(PlanarLayers, one_layer);
    let report = rejection(|| conformance::planar_layers(&method("one-layer", task)));
    assert!(
        report.contains("is no vertex of that ring nor a copy of one"),
        "{report}"
    );
}

#[test]
fn saved_points_read_back_to_the_same_bits() {
    let report = hull_rejection("saves", planar_task!(PlanarHull, panics_on_one_family));
    let (_, path) = report
        .split_once("points saved in ")
        .expect("the report names the file");
    let text = std::fs::read_to_string(path).expect("the file is there");
    let numbers: Vec<f64> = text
        .lines()
        .skip(1)
        .flat_map(|line| line.split(','))
        .map(|number| number.parse().expect("a number"))
        .collect();
    let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let original = magnitudes::huge();
    assert_eq!(bits(&numbers), bits(original.as_flattened()));
}

#[test]
fn a_method_for_another_task_is_refused() {
    let task = planar_task!(PlanarLayers, right_layers);
    let report = rejection(|| conformance::planar_hull(&method("layers", task)));
    assert_eq!(report, "layers does not compute planar hulls");
}
