//! `fast-layers` against the monotone chain, and what it asks.

use geometry_core::{Boundary, Counted, Exact, Hull2, Layers, Points, Silent};
use hull_verify::conformance::hostile::Hostile;
use hull_verify::families::{curves, few, grids, lines, random};
use planar_peeling::chain_peel::chain_peel;
use planar_peeling::fast_layers::{fast_layers, fast_layers_in_portions};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const BOUNDARIES: [Boundary; 2] = [Boundary::Extreme, Boundary::All];

fn fast(points: &[[f64; 2]], boundary: Boundary) -> Layers {
    let points = Points::new(points).expect("finite points");
    fast_layers(points, boundary, &Exact, &mut Silent).expect("no errors")
}

fn in_portions(points: &[[f64; 2]], boundary: Boundary, portion: usize) -> Layers {
    let points = Points::new(points).expect("finite points");
    fast_layers_in_portions(points, boundary, portion, &Exact, &mut Silent).expect("no errors")
}

fn by_chains(points: &[[f64; 2]], boundary: Boundary) -> Layers {
    let points = Points::new(points).expect("finite points");
    chain_peel(points, boundary, &Exact, &mut Silent).expect("no errors")
}

/// Up to 300 points of a small lattice, sheared or not: copies, equal x, many collinear. Or of a disc.
fn degenerate(rng: &mut ChaCha8Rng) -> Vec<[f64; 2]> {
    let most = [8, 40, 150, 300][rng.random_range(0..4)];
    let n = rng.random_range(0..most);
    let [width, height] = [0, 1].map(|_| [1, 2, 4, 9, 30, 1000][rng.random_range(0..6)]);
    let shear = f64::from(rng.random_range(0..3));
    let unit = [1.0, 0.1][rng.random_range(0..2)];
    if rng.random_range(0..4) == 0 {
        return random::disc(rng.random(), n);
    }
    (0..n)
        .map(|_| {
            let [x, y] = [width, height].map(|size| f64::from(rng.random_range(0..size)));
            [(x + shear * y) * unit, (y - shear * x) * unit]
        })
        .collect()
}

/// Seeds on which this once did not end, as few points were all as deep in the shape, or was wrong, as points on an upright
/// edge were taken to be inside.
const FOUND: [u64; 2] = [60_010, 857_783];

/// `FAST_LAYERS_SETS=1000000 cargo test --release -p planar-peeling` for more.
#[test]
fn gives_what_chains_give() {
    let sets = std::env::var("FAST_LAYERS_SETS").map_or(2_000, |sets| {
        sets.parse().expect("FAST_LAYERS_SETS is a number")
    });
    for seed in (0..sets).chain(FOUND) {
        let points = degenerate(&mut ChaCha8Rng::seed_from_u64(seed));
        for boundary in BOUNDARIES {
            let expected = by_chains(&points, boundary);
            let context = || format!("seed {seed}, {boundary:?}: {points:?}");
            assert!(fast(&points, boundary) == expected, "{}", context());
            // Sets as small as these are one portion otherwise.
            for portion in [1, 10] {
                let found = in_portions(&points, boundary, portion);
                assert!(found == expected, "portions of {portion}, {}", context());
            }
        }
    }
}

type Family = (&'static str, fn(usize) -> Vec<[f64; 2]>);

/// Families with n points or a few less, for any n.
const FAMILIES: [Family; 8] = [
    ("disc", |n| random::disc(1, n)),
    ("square", |n| random::square(1, n)),
    ("nested triangles", |n| {
        curves::nested_triangles(n as u32 / 3)
    }),
    ("circle", |n| curves::circle(n as u32)),
    ("lattice", |n| grids::lattice(n.isqrt() as u32)),
    ("collinear", lines::diagonal),
    ("upright", lines::vertical),
    ("copies", |n| few::twice(random::on_grid(1, 20, n / 2))),
];

/// Orientations, divided by n log₂ n.
fn questions(points: &[[f64; 2]], boundary: Boundary) -> f64 {
    let kernel = Counted::new(Exact);
    let view = Points::new(points).expect("finite points");
    fast_layers(view, boundary, &kernel, &mut Silent).expect("no errors");
    let n = points.len() as f64;
    kernel.counts().orientations.total() as f64 / (n * n.log2())
}

/// The count over n log₂ n stays about where it is while n grows sixteenfold (shells begin in between). Any method of order n L would multiply it by
/// more than six in a disc, and by nearly sixteen on nested triangles.
#[test]
fn asks_of_order_n_log_n() {
    for (name, make) in FAMILIES {
        for boundary in BOUNDARIES {
            let [few, more, most] = [2_000, 8_000, 32_000].map(|n| questions(&make(n), boundary));
            let all = format!("{name}, {boundary:?}: {few:.3} {more:.3} {most:.3}");
            assert!(few < 4.5 && more < 4.5 && most < 4.5, "{all}");
            assert!(more < 1.6 * few && most < 1.6 * few, "{all}");
        }
    }
}

/// Quickhull's worst case exists only at sizes that the exponents of doubles allow.
#[test]
fn asks_little_on_the_geometric_parabola() {
    assert!(questions(&curves::geometric_parabola(500), Boundary::Extreme) < 4.5);
}

/// The lattice in the paper of Green and Silverman, figure 2: exactly turned, so that edges stay straight.
#[test]
fn a_turned_lattice_peels_in_five_rings() {
    let cells = (0..100).map(|cell| [f64::from(cell % 10), f64::from(cell / 10)]);
    let points: Vec<[f64; 2]> = cells
        .map(|[u, v]| [3.0 * u - 4.0 * v, 4.0 * u + 3.0 * v])
        .collect();
    let layers = fast(&points, Boundary::All);
    let sizes: Vec<usize> = layers.rings().iter().map(Hull2::len).collect();
    assert_eq!(sizes, [36, 28, 20, 12, 4]);
}

/// Larger than a few leaves: trees of every shape up to depth eight, and long lists.
#[test]
fn gives_what_chains_give_on_larger_sets() {
    for (name, make) in FAMILIES {
        for n in [333, 1_500, 5_000] {
            for boundary in BOUNDARIES {
                let points = make(n);
                let expected = by_chains(&points, boundary);
                for portion in [50, 400, 4096] {
                    let equal = in_portions(&points, boundary, portion) == expected;
                    assert!(equal, "{name} {n}, portions of {portion}, {boundary:?}");
                }
            }
        }
    }
}

/// Also where only one half of the hull knows of a point.
#[test]
fn contradictory_answers_do_no_harm() {
    for (name, make) in FAMILIES {
        for kernel in Hostile::all() {
            for portion in [1, 10, 4096] {
                let points = make(500);
                let view = Points::new(&points).expect("finite points");
                let all = Boundary::All;
                let layers = fast_layers_in_portions(view, all, portion, &kernel, &mut Silent);
                let layers = layers.expect("no errors");
                let ranks = 1..=layers.len() as u32;
                let ranked = layers.c_ranks().iter().all(|rank| ranks.contains(rank));
                assert!(ranked, "{name}, {}, portions of {portion}", kernel.name());
            }
        }
    }
}
