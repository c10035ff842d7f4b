use super::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The determinant over the least power of two of all, from the bits of each coordinate alone.
fn reference(a: Point2, b: Point2, c: Point2) -> Turn {
    let [a, b, c] = [a, b, c].map(|p| p.map(|x| Dyadic::of(x).big_over(-1074)));
    let determinant = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
    Turn::from(determinant.cmp(&BigInt::ZERO))
}

/// A random `f64` whose exponent is in `low..high`, or a zero now and then.
fn coordinate(rng: &mut ChaCha8Rng, low: i32, high: i32) -> f64 {
    let exponent = rng.random_range(low..high);
    let significand: f64 = 1.0 + f64::from(rng.random::<u32>()) / 4_294_967_296.0;
    match rng.random_range(0..12) {
        0 => 0.0,
        1 => -0.0,
        k => {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            // In two steps, so that subnormal results round once and no factor overflows.
            sign * significand * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2)
        }
    }
}

#[test]
fn every_width_agrees_with_big_integers() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut seen = [0; 3];
    for (low, high) in [
        (0, 1),
        (-8, 8),
        (-40, 40),
        (-90, -20),
        (-1080, 1023),
        (-1080, -1020),
    ] {
        for _ in 0..4000 {
            let mut points = [[0.0; 2]; 3];
            for x in points.as_flattened_mut() {
                *x = coordinate(&mut rng, low, high);
            }
            if rng.random_range(0..3) == 0 {
                // Nearly (or, where the halving is exact, exactly) collinear.
                points[2] = [0, 1].map(|i| points[0][i] / 2.0 + points[1][i] / 2.0);
            }
            let frame = Frame::of(&points);
            seen[frame.width() as usize] += 1;
            let [a, b, c] = points;
            assert_eq!(frame.turn(a, b, c), reference(a, b, c), "{points:?}");
            assert_eq!(frame.turn(c, a, b), reference(a, b, c), "{points:?}");
        }
    }
    assert!(seen.iter().all(|&count| count > 1000), "{seen:?}");
}

#[test]
fn the_three_ways_agree_where_all_apply() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for _ in 0..20_000 {
        let mut grid = || f64::from(rng.random_range(-3..=3)) * 0.1;
        let points = [[grid(), grid()], [grid(), grid()], [grid(), grid()]];
        let frame = Frame::of(&points);
        let [a, b, c] = points;
        assert_eq!(frame.width(), Width::Narrow);
        assert_eq!(frame.narrow(a, b, c), frame.medium(a, b, c));
        assert_eq!(frame.narrow(a, b, c), frame.big(a, b, c));
    }
}

#[test]
fn a_value_over_its_lowest_bit_is_odd_and_comes_back() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let special = [
        5e-324,
        -5e-324,
        f64::MAX,
        f64::MIN_POSITIVE,
        1.0,
        -1.5,
        2.0_f64.powi(1023),
    ];
    let random = (0..10_000)
        .map(|_| f64::from_bits(rng.random()))
        .filter(|x| x.is_finite());
    for x in special.into_iter().chain(random) {
        let value = Dyadic::of(x);
        let odd: i64 = value.over(value.lowest_bit());
        assert_eq!(odd % 2, if x < 0.0 { -1 } else { 1 }, "{x:?}");
        let half = value.lowest_bit() / 2;
        let back = odd as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(value.lowest_bit() - half);
        assert_eq!(back, x);
        assert!(
            odd.unsigned_abs().ilog2() as i32 + 1 == value.above_highest_bit() - value.lowest_bit()
        );
    }
}

#[test]
fn products_compare_as_big_integers_do() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut factor = || {
        let x: i128 = match rng.random_range(0..5) {
            0 => i128::from(rng.random_range(-2..=2)),
            1 => i128::MAX - i128::from(rng.random_range(0..3)),
            2 => -(1 << rng.random_range(0..127)),
            _ => rng.random::<u128>() as i128 >> rng.random_range(0..127),
        };
        x
    };
    for _ in 0..100_000 {
        let (left, right) = ([factor(), factor()], [factor(), factor()]);
        let big = |[x, y]: [i128; 2]| BigInt::from(x) * BigInt::from(y);
        assert_eq!(
            wide::compare_products(left, right),
            big(left).cmp(&big(right))
        );
        let close = [left[0], left[1].saturating_sub(1)];
        assert_eq!(
            wide::compare_products(left, close),
            big(left).cmp(&big(close))
        );
        assert!(wide::compare_products(left, [left[1], left[0]]).is_eq());
    }
}

#[test]
fn order_holds_the_two_zeros_equal() {
    assert_eq!(order([0.0, -0.0], [-0.0, 0.0]), Ordering::Equal);
    assert_eq!(order([0.0, 1.0], [0.0, 2.0]), Ordering::Less);
    assert_eq!(order([1.0, 1.0], [0.0, 2.0]), Ordering::Greater);
}

#[test]
fn the_frame_of_nothing_and_of_zeros_is_narrow() {
    assert_eq!(Frame::of(&[]).width(), Width::Narrow);
    let zeros = [[0.0, -0.0]; 3];
    let frame = Frame::of(&zeros);
    assert_eq!(frame.turn(zeros[0], zeros[1], zeros[2]), Turn::Straight);
}
