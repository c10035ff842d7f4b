//! `fast-3d` against the exact quickhull, on small random sets made to be difficult and on large ones with many discards.
//!
//! `FAST_3D_SETS=1000000 cargo test -p quickhull --release --test fast_3d` compares as many small sets.

use geometry_core::{
    Counted, Exact, Hull3, HullError, Point3, Points, Recorder, Silent, Step, Tally,
};
use hull_verify::conformance::space::change::{carried, reorderings};
use hull_verify::families_space::{grids, random, round};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn fast(points: &[Point3]) -> Result<Hull3, HullError> {
    quickhull::fast_3d(Points::new(points)?, &Exact, &mut Silent)
}

fn exact(points: &[Point3]) -> Result<Hull3, HullError> {
    quickhull::quickhull_3d(Points::new(points)?, &Exact, &mut Silent)
}

/// How many small sets are compared.
fn sets() -> u64 {
    let chosen = std::env::var("FAST_3D_SETS").ok();
    chosen.and_then(|text| text.parse().ok()).unwrap_or(3_000)
}

#[test]
fn difficult_sets_have_the_hull_that_exact_answers_give() -> Result<(), HullError> {
    for seed in 0..sets() {
        let points = random::difficult(seed);
        assert_eq!(fast(&points)?, exact(&points)?, "seed {seed}: {points:?}");
    }
    Ok(())
}

/// Large enough for a sample, with all that may go wrong in discarding: ties, flat directions, copies, planes.
fn large_sets() -> Vec<(&'static str, Vec<Point3>)> {
    let n = 6_000;
    let cube = random::cube(5, n);
    let scaled = |by: Point3, offset: f64| -> Vec<Point3> {
        let scale = |p: &Point3| [0, 1, 2].map(|i| p[i] * by[i] + offset);
        cube.iter().map(scale).collect()
    };
    let on_faces = |(number, p): (usize, &Point3)| {
        let mut p = *p;
        p[number % 3] = f64::from(u8::from(p[number % 3] > 0.5));
        p
    };
    vec![
        ("ball", random::ball(1, n)),
        ("cube", cube.clone()),
        ("sphere", round::sphere(1, 5_000)),
        ("lattice", grids::lattice(18)),
        (
            "cube faces",
            cube.iter().enumerate().map(on_faces).collect(),
        ),
        ("flat", scaled([1.0, 1.0, 1e-9], 0.0)),
        ("planar", scaled([1.0, 1.0, 0.0], 0.0)),
        ("needle", scaled([1e9, 1.0, 1.0], 0.0)),
        ("far", scaled([1e-3; 3], 1e6)),
        ("further", scaled([1e-3; 3], 1e12)),
        ("huge", scaled([1e300, 1e299, 1e300], 0.0)),
        ("tiny", scaled([1e-300, 1e-310, 1e-300], 0.0)),
        ("copies", cube[..n / 8].repeat(8)),
        ("few places", grids::lattice(3).repeat(n / 27)),
    ]
}

#[test]
fn large_sets_have_the_hull_that_exact_answers_give() -> Result<(), HullError> {
    for (name, points) in large_sets() {
        let hull = exact(&points)?;
        assert!(fast(&points)? == hull, "{name}");
        for unseen in [quickhull::fast_3d_unseen, quickhull::fast_3d_parallel] {
            assert!(unseen(&points, &Exact)? == hull, "{name}");
        }
        for change in reorderings(&points, 7).into_iter().take(4) {
            let answer = fast(&change.points)?;
            assert!(answer == carried(&hull, &change), "{name}, {}", change.name);
        }
    }
    Ok(())
}

/// A coordinate that is not finite is never discarded, in whatever body or cell the others are.
#[test]
fn the_first_bad_coordinate_of_unseen_points_is_named() {
    let n = 20_000;
    let ball: point_sets::Spec = "ball".parse().expect("a set");
    let sets = [
        ("cube", random::cube(1, n)),
        ("ball", ball.generate3(n, 2).expect("points")),
        ("lattice", grids::lattice(28)),
        ("copies", random::cube(3, n / 8).repeat(8)),
    ];
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for (name, points) in sets {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for trial in 0..30 {
                let (first, wrong) = (rng.random_range(0..points.len()), trial % 3);
                let mut points = points.clone();
                points[first][wrong] = bad;
                let later = rng.random_range(first..points.len());
                points[later][wrong] = bad;
                let answers = [
                    quickhull::fast_3d_unseen(&points, &Exact),
                    quickhull::fast_3d_parallel(&points, &Exact),
                ];
                for answer in answers {
                    let Err(HullError::NotFinite { index, axis, .. }) = answer else {
                        panic!("{name}, {bad}, {first}, {later}: {answer:?}");
                    };
                    assert_eq!((index, axis), (first, wrong), "{name}, {bad}, {later}");
                }
            }
        }
    }
}

/// Points of a facet's plane count as inside, so they cost nothing; a perturbed kernel makes half of them vertices.
#[test]
fn points_in_two_planes_are_not_inserted() -> Result<(), HullError> {
    let mut points = random::cube(3, 10_000);
    for (number, point) in points.iter_mut().enumerate() {
        point[2] = f64::from(number as u32 % 2);
    }
    let mut tally = Tally::default();
    let hull = quickhull::fast_3d(Points::new(&points)?, &Exact, &mut tally)?;
    assert!(tally.inserts < 3 * hull.len() as u64 + 100, "{tally:?}");
    Ok(())
}

/// The kernel is asked only what rounded heights leave open: nothing of random points but the first tetrahedron and the
/// merging, and of a lattice of small integers no more.
#[test]
fn the_kernel_is_asked_little() -> Result<(), HullError> {
    for points in [
        random::ball(2, 3_000),
        random::cube(2, 3_000),
        grids::lattice(12),
    ] {
        let kernel = Counted::new(Exact);
        let mut tally = Tally::default();
        quickhull::fast_3d(Points::new(&points)?, &kernel, &mut tally)?;
        let merging = 3 * (tally.facets - tally.drops);
        let asked = kernel.counts().orientations_in_space.total();
        assert!(asked <= 2 * merging + 1, "{asked} for {merging}");
    }
    Ok(())
}

/// Tests of a point against a plane, all those of a cone counted, or the map, by size: they do not grow.
#[test]
fn tests_of_a_point_do_not_grow() -> Result<(), HullError> {
    type Family = fn(usize) -> Vec<Point3>;
    let families: [(&str, Family, f64); 3] = [
        ("ball", |n| random::ball(1, n), 18.0),
        ("cube", |n| random::cube(1, n), 12.0),
        (
            "lattice",
            |n| grids::lattice((n as f64).cbrt().round() as u32),
            9.0,
        ),
    ];
    for (name, family, most) in families {
        let mut before = most;
        for n in [1_000, 10_000, 100_000] {
            let points = family(n);
            let mut tally = Tally::default();
            quickhull::fast_3d(Points::new(&points)?, &Exact, &mut tally)?;
            let each = tally.visits as f64 / points.len() as f64;
            assert!(each < before, "{name}, n = {n}: {each} after {before}");
            before = each;
        }
    }
    Ok(())
}

/// Every point is told to be discarded or inserted, by its index in the caller's slice.
#[test]
fn steps_are_told_in_the_callers_indices() -> Result<(), HullError> {
    let points = random::ball(4, 6_000);
    let mut recorder = Recorder::default();
    let hull = quickhull::fast_3d(Points::new(&points)?, &Exact, &mut recorder)?;
    let mut is_inserted = vec![false; points.len()];
    for step in &recorder.steps {
        match *step {
            Step::Insert(id) => is_inserted[id as usize] = true,
            Step::Facet(a, b, c) => [a, b, c]
                .map(|id| is_inserted[id as usize] = true)
                .map(drop)[0],
            _ => {}
        }
    }
    assert!(hull.vertices().iter().all(|&id| is_inserted[id as usize]));
    Ok(())
}
