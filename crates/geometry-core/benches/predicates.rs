//! Nanoseconds a question, beside the `robust` and `geometry-predicates` crates, on easy, near-degenerate and
//! degenerate input; and before that, how often each stage of the exact kernel is reached on each input.
//!
//! Run with `cargo bench -p geometry-core --bench predicates`.

#![allow(clippy::print_stdout, missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use geometry_core::{
    Counted, Exact, InCircle, Kernel2, Kernel3, Point2, Point3, Sign, StageCounts,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;

const QUESTIONS: usize = 2_000;

/// A class of input: a name and its quadruples.
type Class<P> = (&'static str, Vec<[P; 4]>);

/// A contestant: its name and its answer.
type Contestant<P> = (&'static str, fn(&[P; 4]) -> Sign);

/// Moves `x` by up to two units in the last place.
fn nudged(rng: &mut ChaCha8Rng, x: f64) -> f64 {
    let steps = rng.random_range(-2_i64..=2);
    f64::from_bits((x.to_bits() as i64 + steps) as u64)
}

fn class<P>(name: &'static str, mut quadruple: impl FnMut(&mut ChaCha8Rng) -> [P; 4]) -> Class<P> {
    let mut rng = ChaCha8Rng::seed_from_u64(1979);
    (name, (0..QUESTIONS).map(|_| quadruple(&mut rng)).collect())
}

fn uniform<const D: usize>(rng: &mut ChaCha8Rng) -> [f64; D] {
    std::array::from_fn(|_| rng.random())
}

/// Points on a line, on a plane spanned by two vectors, in floating point or exactly.
fn affine<const D: usize>(base: [f64; D], terms: &[([f64; D], f64)]) -> [f64; D] {
    std::array::from_fn(|i| terms.iter().fold(base[i], |sum, (v, t)| sum + v[i] * t))
}

fn small_integers<const D: usize>(rng: &mut ChaCha8Rng) -> [f64; D] {
    std::array::from_fn(|_| f64::from(rng.random_range(-500_i32..500)))
}

fn collinear_classes() -> Vec<Class<Point2>> {
    vec![
        class("easy", |rng| std::array::from_fn(|_| uniform(rng))),
        class("near", |rng| {
            let (base, v): (Point2, Point2) = (uniform(rng), uniform(rng));
            std::array::from_fn(|_| affine(base, &[(v, rng.random())]).map(|x| nudged(rng, x)))
        }),
        class("degenerate", |rng| {
            let (base, v): (Point2, Point2) = (small_integers(rng), small_integers(rng));
            std::array::from_fn(|_| affine(base, &[(v, f64::from(rng.random_range(-99_i32..99)))]))
        }),
    ]
}

fn coplanar_classes() -> Vec<Class<Point3>> {
    vec![
        class("easy", |rng| std::array::from_fn(|_| uniform(rng))),
        class("near", |rng| {
            let [base, v, w]: [Point3; 3] = std::array::from_fn(|_| uniform(rng));
            std::array::from_fn(|_| {
                affine(base, &[(v, rng.random()), (w, rng.random())]).map(|x| nudged(rng, x))
            })
        }),
        class("degenerate", |rng| {
            let [base, v, w]: [Point3; 3] = std::array::from_fn(|_| small_integers(rng));
            let mut factor = || f64::from(rng.random_range(-99_i32..99));
            std::array::from_fn(|_| affine(base, &[(v, factor()), (w, factor())]))
        }),
    ]
}

fn cocircular_classes() -> Vec<Class<Point2>> {
    vec![
        class("easy", |rng| std::array::from_fn(|_| uniform(rng))),
        class("near", |rng| {
            let center: Point2 = uniform(rng);
            std::array::from_fn(|_| {
                let (sin, cos) = rng.random_range(0.0..std::f64::consts::TAU).sin_cos();
                [center[0] + cos, center[1] + sin]
            })
        }),
        class("degenerate", |rng| {
            // The twelve lattice points on the circle of radius 65 in the open first quadrant, and reflections.
            const ON_CIRCLE: [[f64; 2]; 4] =
                [[16.0, 63.0], [25.0, 60.0], [33.0, 56.0], [39.0, 52.0]];
            let center: Point2 = small_integers(rng);
            std::array::from_fn(|_| {
                let p = ON_CIRCLE[rng.random_range(0..4)];
                let sign = |rng: &mut ChaCha8Rng| if rng.random() { 1.0 } else { -1.0 };
                [center[0] + sign(rng) * p[0], center[1] + sign(rng) * p[1]]
            })
        }),
    ]
}

/// Times one question of each contestant over all quadruples, a contestant's answers checked against ours.
fn contest<P: Copy>(
    criterion: &mut Criterion,
    question: &str,
    classes: &[Class<P>],
    contestants: &[Contestant<P>],
) {
    for (class, quadruples) in classes {
        let mut group = criterion.benchmark_group(format!("{question}/{class}"));
        group.throughput(Throughput::Elements(quadruples.len() as u64));
        for (name, ask) in contestants {
            for quadruple in quadruples {
                assert_eq!(
                    ask(quadruple),
                    contestants[0].1(quadruple),
                    "{question}/{class}: {name} is wrong"
                );
            }
            group.bench_function(*name, |bencher| {
                bencher.iter(|| {
                    let answers = quadruples.iter().map(|q| ask(black_box(q)) as i64);
                    black_box(answers.sum::<i64>())
                });
            });
        }
        group.finish();
    }
}

fn coord2(p: Point2) -> robust::Coord<f64> {
    robust::Coord { x: p[0], y: p[1] }
}

fn coord3(p: Point3) -> robust::Coord3D<f64> {
    robust::Coord3D {
        x: p[0],
        y: p[1],
        z: p[2],
    }
}

fn orientation(criterion: &mut Criterion) {
    contest::<Point2>(
        criterion,
        "orient2",
        &collinear_classes(),
        &[
            ("ours", |[a, b, c, _]| Exact.orient(*a, *b, *c)),
            ("robust", |[a, b, c, _]| {
                Sign::of(robust::orient2d(coord2(*a), coord2(*b), coord2(*c)))
            }),
            ("geometry-predicates", |[a, b, c, _]| {
                Sign::of(geometry_predicates::orient2d(*a, *b, *c))
            }),
        ],
    );
    contest::<Point2>(
        criterion,
        "compare_distance",
        &collinear_classes(),
        &[("ours", |[a, b, p, q]| {
            Sign::from(Exact.compare_distance(*a, *b, *p, *q))
        })],
    );
}

fn orientation_in_space(criterion: &mut Criterion) {
    // Shewchuk's sign convention for four points is the opposite of ours.
    contest::<Point3>(
        criterion,
        "orient3",
        &coplanar_classes(),
        &[
            ("ours", |[a, b, c, d]| Exact.orient3(*a, *b, *c, *d)),
            ("robust", |[a, b, c, d]| {
                -Sign::of(robust::orient3d(
                    coord3(*a),
                    coord3(*b),
                    coord3(*c),
                    coord3(*d),
                ))
            }),
            ("geometry-predicates", |[a, b, c, d]| {
                -Sign::of(geometry_predicates::orient3d(*a, *b, *c, *d))
            }),
        ],
    );
}

fn in_circle(criterion: &mut Criterion) {
    contest::<Point2>(
        criterion,
        "in_circle",
        &cocircular_classes(),
        &[
            ("ours", |[a, b, c, d]| Exact.in_circle(*a, *b, *c, *d)),
            ("robust", |[a, b, c, d]| {
                Sign::of(robust::incircle(
                    coord2(*a),
                    coord2(*b),
                    coord2(*c),
                    coord2(*d),
                ))
            }),
            ("geometry-predicates", |[a, b, c, d]| {
                Sign::of(geometry_predicates::incircle(*a, *b, *c, *d))
            }),
        ],
    );
}

/// Prints how many of the questions each stage settled.
fn stages(_: &mut Criterion) {
    println!("questions settled by filter / adaptive / integer stage, of {QUESTIONS}");
    let print = |question: &str, class: &str, n: StageCounts| {
        println!(
            "  {question}/{class}: {} / {} / {}",
            n.filter, n.adaptive, n.integer
        );
    };
    for (class, quadruples) in collinear_classes() {
        let kernel = Counted::new(Exact);
        for [a, b, c, _] in quadruples {
            black_box(kernel.orient(a, b, c));
        }
        print("orient2", class, kernel.counts().orientations);
    }
    for (class, quadruples) in coplanar_classes() {
        let kernel = Counted::new(Exact);
        for [a, b, c, d] in quadruples {
            black_box(kernel.orient3(a, b, c, d));
        }
        print("orient3", class, kernel.counts().orientations_in_space);
    }
    for (class, quadruples) in cocircular_classes() {
        let kernel = Counted::new(Exact);
        for [a, b, c, d] in quadruples {
            black_box(kernel.in_circle(a, b, c, d));
        }
        print("in_circle", class, kernel.counts().in_circles);
    }
}

criterion_group!(
    benches,
    stages,
    orientation,
    orientation_in_space,
    in_circle
);
criterion_main!(benches);
