//! `Perturbed` in space against points that really are moved, in integers of thousands of bits.

use geometry_core::{Axis, Exact, Kernel3, Perturbed, Point3, Sign};
use num_bigint::{BigInt, Sign as BigSign};

/// The lattice 3 x 3 x 3 in lexicographic order, so that the index is the rank.
fn lattice() -> Vec<Point3> {
    (0..27)
        .map(|i| [i / 9, i / 3 % 3, i % 3].map(f64::from))
        .collect()
}

type Moved = [BigInt; 3];

/// The points, given by ascending rank, times 2^UNIT, each moved by (-α, +β, +γ) of its rank within the question.
fn moved<const N: usize>(points: [Point3; N]) -> [Moved; N] {
    const UNIT: usize = 8 << 13;
    let mut rank = 0;
    points.map(|p| {
        // Levels γ, β, α of this rank; each level is smaller than the product of all before it, times 2^-8.
        let level = |k: usize| BigInt::from(1) << (UNIT - (8 << (3 * rank + k)));
        let [x, y, z] = p.map(|x| BigInt::from(x as i64) << UNIT);
        let result = [x - level(2), y + level(1), z + level(0)];
        rank += 1;
        result
    })
}

fn sign(value: &BigInt) -> Sign {
    match value.sign() {
        BigSign::Minus => Sign::Negative,
        BigSign::NoSign => Sign::Zero,
        BigSign::Plus => Sign::Positive,
    }
}

fn cross([ax, ay]: [&BigInt; 2], [bx, by]: [&BigInt; 2], [cx, cy]: [&BigInt; 2]) -> BigInt {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

fn shadow(axis: Axis, p: &Moved) -> [&BigInt; 2] {
    match axis {
        Axis::X => [&p[1], &p[2]],
        Axis::Y => [&p[2], &p[0]],
        Axis::Z => [&p[0], &p[1]],
    }
}

fn volume([a, b, c, d]: &[Moved; 4]) -> BigInt {
    let normal = Axis::ALL.map(|axis| cross(shadow(axis, a), shadow(axis, b), shadow(axis, c)));
    (0..3).map(|i| &normal[i] * (&d[i] - &a[i])).sum()
}

#[test]
fn orientations_are_those_of_moved_points() {
    let points = lattice();
    let mut degenerate = 0;
    for a in 0..27 {
        for b in a + 1..27 {
            for c in b + 1..27 {
                for d in c + 1..27 {
                    let [a, b, c, d] = [a, b, c, d].map(|i: usize| points[i]);
                    let answer = Perturbed(Exact).orient3(a, b, c, d);
                    let exact = Exact.orient3(a, b, c, d);
                    if exact.is_zero() {
                        degenerate += 1;
                        assert_eq!(
                            answer,
                            sign(&volume(&moved([a, b, c, d]))),
                            "{a:?} {b:?} {c:?} {d:?}"
                        );
                    } else {
                        assert_eq!(answer, exact);
                    }
                    assert_eq!(Perturbed(Exact).orient3(b, d, a, c), -answer);
                    assert_eq!(Perturbed(Exact).orient3(c, a, b, d), answer);
                }
            }
        }
    }
    assert!(
        degenerate > 1000,
        "the lattice has many coplanar quadruples, found {degenerate}"
    );
}

#[test]
fn shadows_are_those_of_moved_points() {
    let points = lattice();
    for a in 0..27 {
        for b in a + 1..27 {
            for c in b + 1..27 {
                let triple @ [a, b, c] = [a, b, c].map(|i: usize| points[i]);
                let [p, q, r] = moved(triple);
                for axis in Axis::ALL {
                    let answer = Perturbed(Exact).shadow(axis, a, b, c);
                    let expected = cross(shadow(axis, &p), shadow(axis, &q), shadow(axis, &r));
                    assert_eq!(answer, sign(&expected), "{axis:?} {a:?} {b:?} {c:?}");
                    assert_eq!(Perturbed(Exact).shadow(axis, b, a, c), -answer);
                }
            }
        }
    }
}

#[test]
fn copies_still_give_zero() {
    let p = [1.0, 2.0, 3.0];
    assert_eq!(
        Perturbed(Exact).orient3(p, [0.0; 3], p, [4.0, 0.0, 1.0]),
        Sign::Zero
    );
}
