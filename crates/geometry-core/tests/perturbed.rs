//! `Perturbed` never answers zero for distinct points, agrees with `Exact` elsewhere, and its answers are those
//! of real points: the same as `Exact` gives after a small real displacement in the direction it stands for.

use geometry_core::{Exact, Kernel2, Perturbed, Point2, Sign};

const SIDE: i32 = 4;

fn lattice() -> Vec<Point2> {
    (0..SIDE * SIDE)
        .map(|i| [f64::from(i / SIDE), f64::from(i % SIDE)])
        .collect()
}

/// The lattice moved as the header of `perturbed.rs` says, with δ and ε that are small and far enough apart for
/// the determinants of a 4 x 4 lattice: the point of rank r moves by (-2^(-8r-12), 2^(-8r-8)) … all exact in f64
/// would need hundreds of bits, so only the three or four points of a question are moved, by their relative rank.
fn moved<const N: usize>(points: [Point2; N]) -> [Point2; N] {
    let mut distinct: Vec<Point2> = points.to_vec();
    distinct.sort_by(|a, b| Exact.lexicographic(*a, *b));
    distinct.dedup();
    points.map(|p| {
        let rank = distinct
            .iter()
            .position(|&q| q == p)
            .expect("every point is in the list of all points");
        let unit = 2_f64.powi(-10 * rank as i32 - 6);
        [p[0] - unit / 32.0, p[1] + unit]
    })
}

#[test]
fn orientations_are_those_of_displaced_points() {
    let points = lattice();
    for &a in &points {
        for &b in &points {
            for &c in &points {
                let answer = Perturbed(Exact).orient(a, b, c);
                let distinct = a != b && b != c && a != c;
                assert_eq!(answer != Sign::Zero, distinct, "{a:?} {b:?} {c:?}");
                let exact = Exact.orient(a, b, c);
                if exact != Sign::Zero {
                    assert_eq!(answer, exact);
                } else if distinct {
                    let [a, b, c] = moved([a, b, c]);
                    assert_eq!(answer, Exact.orient(a, b, c), "{a:?} {b:?} {c:?}");
                }
            }
        }
    }
}

#[test]
fn distances_are_those_of_displaced_points() {
    let points = lattice();
    for &a in &points {
        for &b in points.iter().filter(|&&b| b != a) {
            for &p in &points {
                for &q in &points {
                    let answer = Perturbed(Exact).compare_distance(a, b, p, q);
                    let reversed = Perturbed(Exact).compare_distance(a, b, q, p);
                    assert_eq!(answer, reversed.reverse());
                    let same = p == q || [(a, b), (b, a)].contains(&(p, q));
                    assert_eq!(answer.is_eq(), same, "{a:?} {b:?} {p:?} {q:?}");
                    let [a, b, p, q] = moved([a, b, p, q]);
                    assert_eq!(
                        answer,
                        Exact.compare_distance(a, b, p, q),
                        "{a:?} {b:?} {p:?} {q:?}"
                    );
                }
            }
        }
    }
}
