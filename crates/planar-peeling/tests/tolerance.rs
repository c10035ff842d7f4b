//! Table 1 of the paper: what a tolerance that is too small does to a lattice in single precision.

use geometry_core::tolerance::formats::Single;
use geometry_core::{Boundary, Points, Silent, Tolerance};
use planar_peeling::peel::gs_peel;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// How many of `rotations` of the 10 × 10 lattice of the unit square peel as they should.
fn right(epsilon: f64, rotations: usize) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(1979);
    let kernel = Tolerance::<Single>::new(epsilon);
    let stages = |cell: u32| {
        let [u, v] = [cell % 10, cell / 10];
        1 + u.min(9 - u).min(v).min(9 - v)
    };
    let expected: Vec<u32> = (0..100).map(stages).collect();
    let angles = (0..rotations).map(|_| rng.random_range(0.1..1.4_f64));
    let peeled_right = |angle: &f64| {
        let (sine, cosine) = angle.sin_cos();
        let cells = (0..100).map(|cell| [f64::from(cell % 10) / 9.0, f64::from(cell / 10) / 9.0]);
        let points: Vec<[f64; 2]> = cells
            .map(|[u, v]| [cosine * u - sine * v, sine * u + cosine * v])
            .collect();
        let points = Points::new(&points).expect("finite points");
        let layers = gs_peel(points, Boundary::All, &kernel, &mut Silent);
        layers.expect("few points").c_ranks() == expected
    };
    angles.filter(peeled_right).count()
}

#[test]
fn a_tolerance_above_the_rounding_is_right() {
    for epsilon in [1e-4, 1e-5, 1e-6] {
        assert_eq!(right(epsilon, 60), 60, "epsilon {epsilon:e}");
    }
}

/// "Method fails if ε ≤ 10⁻⁸" on the machine with the shorter word.
#[test]
fn a_tolerance_below_the_rounding_is_wrong() {
    assert!(right(1e-8, 60) < 10);
    assert_eq!(right(1e-9, 60), 0);
    assert_eq!(right(0.0, 60), 0);
}
