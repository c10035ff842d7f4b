//! Many small random sets, most of them degenerate, and the same hull as from a monotone chain that asks the exact kernel
//! everything.
//!
//! 25,000 sets by default; `FAST_2D_SETS` says otherwise (a million take some minutes with `--release`).

use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, Exact, Hull2, Kernel2, Point2, Points, Sign};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const SETS: u64 = 25_000;

#[test]
fn random_sets_have_the_hull_of_a_monotone_chain() {
    let sets = std::env::var("FAST_2D_SETS").map_or(SETS, |text| {
        text.parse().expect("FAST_2D_SETS is a number of sets")
    });
    // Up to some 200 points; one set in thousand has some thousands, as only then a sample is taken.
    for seed in 0..sets {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let n = match rng.random_range(0..1000) {
            0 => rng.random_range(4_000..9_000),
            1..500 => rng.random_range(0..40),
            _ => rng.random_range(0..200),
        };
        check(seed, set(n, &mut rng));
    }
}

/// Of so many points, the first may improve the polygon for the others.
#[test]
fn sets_of_many_points_have_it() {
    for seed in 0..20 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let n = rng.random_range(66_000..80_000);
        check(seed, set(n, &mut rng));
    }
}

/// As they are, and in another order.
fn check(seed: u64, mut points: Vec<Point2>) {
    for _ in 0..2 {
        for boundary in [Boundary::Extreme, Boundary::All] {
            let hull = quickhull::convex_hull(&points, boundary).expect("finite points");
            let expected = monotone_chain(&points, boundary);
            assert_eq!(hull, expected, "seed {seed}, {boundary:?}");
        }
        points.reverse();
        let turn = seed as usize % points.len().max(1);
        points.rotate_left(turn);
    }
}

/// Points of a kind that the generator picks.
fn set(n: usize, rng: &mut ChaCha8Rng) -> Vec<Point2> {
    let kind = rng.random_range(0..10_u32);
    let side = rng.random_range(1..30_i32);
    let scale = 2.0_f64.powi(rng.random_range(-1060..1015));
    let slope = rng.random_range(-3.0..3.0_f64);
    let points = std::iter::repeat_with(|| match kind {
        // A lattice.
        0 => [0, 1].map(|_| f64::from(rng.random_range(0..side))),
        // The same, scaled to any magnitude.
        1 => [0, 1].map(|_| scale * f64::from(rng.random_range(-side..=side)) / 32.0),
        // A lattice of tenths, where rounding bends lines.
        2 => [0, 1].map(|_| 0.1 * f64::from(rng.random_range(0..side))),
        // Near a slanted line: off it by rounding and some units in the last place.
        3 => {
            let x: f64 = rng.random();
            let y = slope * x;
            [
                x,
                f64::from_bits(y.to_bits().wrapping_add(rng.random_range(0..3))),
            ]
        }
        // A disc, and one far from the origin.
        4 => in_disc(rng),
        5 => in_disc(rng).map(|x| 1e6 + x),
        // A circle of integers: collinear and cocircular points.
        6 => circle_of_integers(rng),
        // Any bits that make a finite number.
        7 => [0, 1].map(|_| any_finite(rng)),
        // Magnitudes of every size beside each other, with few digits.
        8 => [0, 1].map(|_| {
            let exponent = rng.random_range(-40..40);
            f64::from(rng.random_range(-4..=4_i32)) * 2.0_f64.powi(exponent)
        }),
        // A long and slanted strip.
        _ => {
            let (along, across): (f64, f64) = (rng.random(), rng.random());
            [along - 1e-9 * across, slope * along + 1e-9 * across]
        }
    });
    points.take(n).collect()
}

fn in_disc(rng: &mut ChaCha8Rng) -> Point2 {
    loop {
        let [x, y] = [0, 1].map(|_| rng.random_range(-1.0..1.0_f64));
        if x * x + y * y < 1.0 {
            return [x, y];
        }
    }
}

fn circle_of_integers(rng: &mut ChaCha8Rng) -> Point2 {
    const FIRST: [Point2; 3] = [[25.0, 0.0], [24.0, 7.0], [20.0, 15.0]];
    let [x, y] = FIRST[rng.random_range(0..FIRST.len())];
    let signed = [x * sign(rng), y * sign(rng)];
    if rng.random() {
        signed
    } else {
        [signed[1], signed[0]]
    }
}

fn sign(rng: &mut ChaCha8Rng) -> f64 {
    if rng.random() { 1.0 } else { -1.0 }
}

fn any_finite(rng: &mut ChaCha8Rng) -> f64 {
    loop {
        let x = f64::from_bits(rng.random());
        if x.is_finite() {
            return x;
        }
    }
}

/// Andrew's monotone chain, as short as it can be written.
fn monotone_chain(points: &[Point2], boundary: Boundary) -> Hull2 {
    let points = Points::new(points).expect("finite points");
    let mut ids: Vec<u32> = points.ids().collect();
    sort_distinct(points, &mut ids, &Exact);
    let (Some(&first), Some(&last)) = (ids.first(), ids.last()) else {
        return Hull2::Empty;
    };
    if ids.iter().all(|&id| {
        Exact
            .orient(points[first], points[last], points[id])
            .is_zero()
    }) {
        return Hull2::of_collinear(points, ids, boundary, &Exact);
    }
    let mut cycle = half(points, ids.iter().copied(), boundary);
    cycle.extend(half(points, ids.iter().rev().copied(), boundary));
    Hull2::from_cycle(points, cycle)
}

/// The chain of points in order, without its last one.
fn half(points: Points<'_, 2>, ids: impl Iterator<Item = u32>, boundary: Boundary) -> Vec<u32> {
    let mut chain: Vec<u32> = Vec::new();
    for id in ids {
        while let [.., a, b] = chain[..] {
            let turn = Exact.orient(points[a], points[b], points[id]);
            if turn == Sign::Positive || (turn == Sign::Zero && boundary == Boundary::All) {
                break;
            }
            chain.pop();
        }
        chain.push(id);
    }
    chain.pop();
    chain
}
