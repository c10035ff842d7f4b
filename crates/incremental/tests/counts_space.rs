//! What the insertions of space ask and make, counted.

use geometry_core::Step::*;
use geometry_core::{
    Counted, Exact, Hull3, HullError, Observer, Point3, Points, Recorder, Silent, Tally,
};
use hull_verify::families_space::{random, round};
use incremental::{Order, incremental_3d_in, incremental_conflict_in};

/// All points extreme, no four coplanar: the i-th point is tested against the 2(i-1) - 4 facets before it. Set-up
/// asks one orientation, that of the first tetrahedron; the merging of coplanar facets at the end one for each
/// edge.
#[test]
fn visibility_tests_on_a_sphere_are_exactly_as_many() -> Result<(), HullError> {
    for n in [4, 5, 10, 100, 1_000] {
        let points = round::sphere(5, n);
        let n = n as u64;
        for order in [Order::AsGiven, Order::Shuffled { seed: 7 }] {
            let kernel = Counted::new(Exact);
            let hull = incremental_3d_in(Points::new(&points)?, order, &kernel, &mut Silent)?;
            assert_eq!(hull.len() as u64, n);
            assert_eq!(hull.triangles().count() as u64, 2 * n - 4);
            let (start, merging) = (1, 3 * (n - 2));
            let tests = kernel.counts().orientations_in_space.total() - start - merging;
            assert_eq!(tests, (n - 1) * (n - 4), "n = {n}");
        }
    }
    Ok(())
}

/// In a ball the tests are the sum of the expected numbers of facets, about 6 n^1.5.
#[test]
fn visibility_tests_in_a_ball_are_fewer() -> Result<(), HullError> {
    let n = 4_000;
    let points = random::ball(5, n);
    let kernel = Counted::new(Exact);
    incremental_3d_in(
        Points::new(&points)?,
        Order::default(),
        &kernel,
        &mut Silent,
    )?;
    let tests = kernel.counts().orientations_in_space.total() as f64;
    let ratio = tests / (n as f64).powf(1.5);
    assert!((5.0..6.5).contains(&ratio), "{ratio}");
    Ok(())
}

fn facets_made(points: &[Point3], order: Order) -> Result<u64, HullError> {
    let mut tally = Tally::default();
    incremental_conflict_in(Points::new(points)?, order, &Exact, &mut tally)?;
    Ok(tally.facets)
}

/// The expected degree of the point inserted last is 6 - 12/i: 6 n - O(log n) facets in all.
#[test]
fn facets_made_on_a_sphere_tend_to_six_a_point() -> Result<(), HullError> {
    for (n, seeds, expected, tolerance) in [
        (1_000, 8, 5.91, 0.05),
        (10_000, 2, 5.988, 0.02),
        (100_000, 1, 6.0, 0.01),
    ] {
        let points = round::sphere(6, n);
        let mut made = 0;
        for seed in 0..seeds {
            made += facets_made(&points, Order::Shuffled { seed })?;
        }
        let each = made as f64 / (seeds as usize * n) as f64;
        assert!((each - expected).abs() < tolerance, "n = {n}: {each}");
    }
    Ok(())
}

/// Half the points on a circle, half up its axis: n²/4 facets in this order, O(n) in a random one.
#[test]
fn a_bad_order_makes_a_quarter_of_the_square() -> Result<(), HullError> {
    for half in [10_u32, 50, 200] {
        let turn = std::f64::consts::TAU / f64::from(half);
        let circle = (0..half).map(|i| {
            [
                (f64::from(i) * turn).cos(),
                (f64::from(i) * turn).sin(),
                0.0,
            ]
        });
        let points: Vec<Point3> = circle
            .chain((1..=half).map(|z| [0.0, 0.0, f64::from(z)]))
            .collect();
        let n = u64::from(2 * half);
        // Each point of the axis after the first is joined to the whole circle.
        let bad = facets_made(&points, Order::AsGiven)?;
        let cones = n * n / 4 - n / 2;
        assert!((cones..cones + 10 * n).contains(&bad), "n = {n}: {bad}");
        let random = facets_made(&points, Order::default())?;
        assert!(random < 10 * n, "n = {n}: {random}");
    }
    Ok(())
}

/// Both methods make and drop the same facets: the graph only spares the questions.
#[test]
fn the_conflict_graph_changes_the_questions_alone() -> Result<(), HullError> {
    for points in [
        random::ball(8, 300),
        round::sphere(8, 300),
        random::on_grid(8, 4, 200),
    ] {
        let changes = |steps: Vec<geometry_core::Step>| -> Vec<[u32; 3]> {
            let mut changes: Vec<_> = steps
                .into_iter()
                .filter_map(|step| match step {
                    Facet(a, b, c) | Drop(a, b, c) => {
                        let first = a.min(b).min(c);
                        let turned = [[a, b, c], [b, c, a], [c, a, b]];
                        turned.into_iter().find(|corners| corners[0] == first)
                    }
                    _ => None,
                })
                .collect();
            changes.sort_unstable();
            changes
        };
        let (mut plain, mut graph) = (Recorder::default(), Recorder::default());
        let kernels = [Counted::new(Exact), Counted::new(Exact)];
        let points = Points::new(&points)?;
        let hulls = [
            incremental::incremental_3d(points, &kernels[0], &mut plain)?,
            incremental::incremental_conflict(points, &kernels[1], &mut graph)?,
        ];
        assert_eq!(hulls[0], hulls[1]);
        assert_eq!(changes(plain.steps), changes(graph.steps));
        let [all, few] = kernels.map(|kernel| kernel.counts().orientations_in_space.total());
        assert!(few < all, "{few} against {all}");
    }
    Ok(())
}

#[test]
fn a_seed_changes_the_order_and_not_the_hull() -> Result<(), HullError> {
    let points = random::ball(9, 400);
    let points = Points::new(&points)?;
    let run = |seed: u64, observer: &mut Recorder| {
        incremental::incremental_conflict_seeded(points, seed, &Exact, observer)
    };
    let [mut first, mut again, mut other] = [(); 3].map(|()| Recorder::default());
    let hull: Hull3 = run(1, &mut first)?;
    assert_eq!(run(1, &mut again)?, hull);
    assert_eq!(run(2, &mut other)?, hull);
    assert_eq!(first.steps, again.steps);
    assert_ne!(first.steps, other.steps);
    assert_eq!(
        incremental::incremental_3d_seeded(points, 3, &Exact, &mut Silent)?,
        hull
    );
    Ok(())
}

/// A tetrahedron, a point inside, and a point beyond one facet.
#[test]
fn a_trace_tells_what_is_dropped() -> Result<(), HullError> {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [0.0, 0.0, 4.0],
        [0.5, 0.5, 0.5],
        [2.0, 2.0, 2.0],
    ];
    let points = Points::new(&points)?;
    let steps = |run: &dyn Fn(&mut Recorder) -> Result<Hull3, HullError>| {
        let mut recorder = Recorder::default();
        run(&mut recorder).map(|_| recorder.steps)
    };
    #[rustfmt::skip]
    let expected = [
        Facet(0, 2, 1), Facet(0, 1, 3), Facet(1, 2, 3), Facet(2, 0, 3),
        Visit(4), Discard(4),
        Visit(5), Drop(1, 2, 3), Insert(5), Facet(1, 2, 5), Facet(2, 3, 5), Facet(3, 1, 5),
    ];
    assert_eq!(
        steps(&|recorder| incremental_3d_in(points, Order::AsGiven, &Exact, recorder))?,
        expected
    );
    #[rustfmt::skip]
    let expected = [
        Facet(0, 2, 1), Visit(4), Visit(5), Facet(0, 1, 3), Visit(4), Visit(5),
        Facet(1, 2, 3), Visit(4), Visit(5), Facet(2, 0, 3), Visit(4), Visit(5),
        Discard(4),
        Insert(5), Facet(1, 2, 5), Facet(2, 3, 5), Facet(3, 1, 5), Drop(1, 2, 3), Storage(0),
    ];
    assert_eq!(
        steps(&|recorder| incremental_conflict_in(points, Order::AsGiven, &Exact, recorder))?,
        expected
    );
    Ok(())
}

/// The trace is the same whoever listens.
#[test]
fn tallies_agree_with_traces() -> Result<(), HullError> {
    fn count<O: Observer>(points: Points<'_, 3>, observer: &mut O) -> Result<(), HullError> {
        incremental::incremental_3d(points, &Exact, observer).map(|_| ())
    }
    let points = random::cube(10, 200);
    let points = Points::new(&points)?;
    let (mut tally, mut recorder) = (Tally::default(), Recorder::default());
    count(points, &mut tally)?;
    count(points, &mut recorder)?;
    let facets = recorder
        .steps
        .iter()
        .filter(|step| matches!(step, Facet(..)))
        .count();
    assert_eq!(tally.facets as usize, facets);
    assert_eq!(tally.visits, tally.inserts + tally.discards);
    Ok(())
}
