//! What Jarvis's methods ask, counted against the formulas in their headers.

use geometry_core::{
    Boundary, Counted, Exact, Hull2, Kernel2, Method, Point2, Points, QuestionCounts, Tally, Task,
};
use hull_verify::families::{curves, random};

fn counted(slug: &str, points: &[Point2]) -> (Hull2, QuestionCounts, Tally) {
    let method: &Method = gift_wrap::METHODS
        .iter()
        .find(|method| method.slug == slug)
        .expect("the slug is registered");
    let Task::PlanarHull(entry) = method.task else {
        panic!("{slug} does not compute planar hulls");
    };
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let points = Points::new(points).expect("finite points");
    let hull =
        (entry.tallied)(points, Boundary::Extreme, &kernel, &mut tally).expect("an exact kernel");
    (hull, kernel.counts(), tally)
}

/// Sets without copies and without three collinear points.
fn general_sets() -> [Vec<Point2>; 3] {
    [
        random::disc(3, 60),
        random::disc(4, 1_000),
        curves::parabola(40),
    ]
}

#[test]
fn j1_asks_every_point_at_every_vertex() {
    for points in general_sets() {
        let (hull, counts, tally) = counted("jarvis-j1", &points);
        let (n, h) = (points.len() as u64, hull.len() as u64);
        assert_eq!(counts.orientations.total(), h * (n - 2));
        assert_eq!(tally.visits, h * (n - 1));
        assert_eq!((tally.pushes, tally.edges), (h, h));
    }
}

#[test]
fn j2_asks_only_the_points_beyond_the_last_vertex() {
    for points in general_sets() {
        let (hull, counts, tally) = counted("jarvis-j2", &points);
        let ids = hull.vertices();
        let beyond = |id: &u32| {
            let (first, last) = (points[ids[0] as usize], points[*id as usize]);
            let left = points
                .iter()
                .filter(|&&p| Exact.orient(first, last, p).is_positive());
            left.count() as u64
        };
        let expected: u64 = ids[1..].iter().map(beyond).sum();
        assert_eq!(counts.orientations.total(), expected);
        // All points but the first are vertices or passed.
        assert_eq!(tally.discards as usize, points.len() - hull.len());
    }
}

#[test]
fn j3_asks_only_the_points_further_on() {
    for points in general_sets() {
        let (hull, counts, _) = counted("jarvis-j3", &points);
        let ids = hull.vertices();
        let right_of = |id: u32| {
            points
                .iter()
                .filter(|p| p[0] > points[id as usize][0])
                .count()
        };
        let rightmost = (0..ids.len())
            .find(|&i| right_of(ids[i]) == 0)
            .expect("not empty");
        let lower = ids[..rightmost].iter().map(|&id| right_of(id) - 1);
        let upper = ids[rightmost..]
            .iter()
            .map(|&id| points.len() - right_of(id) - 2);
        let expected: usize = lower.chain(upper).sum();
        assert_eq!(counts.orientations.total() as usize, expected);
    }
}

/// On a disc the two refinements ask about half of what the plain march asks, and no more than n log n for the sort.
#[test]
fn the_refinements_halve_the_searches() {
    let n = 10_000;
    let points = random::disc(5, n);
    let plain = counted("jarvis-j1", &points).1.orientations.total() as f64;
    for slug in ["jarvis-j2", "jarvis-j3"] {
        let (_, counts, _) = counted(slug, &points);
        let share = counts.orientations.total() as f64 / plain;
        assert!((0.4..0.6).contains(&share), "{slug}: {share}");
        let sort_limit = n as u64 * (n as f64).log2().ceil() as u64;
        assert!(counts.angles.max(counts.lexicographic) <= sort_limit + 2 * n as u64);
    }
}
