//! The number formats against the hardware's, and against figures worked out by hand.

use geometry_core::tolerance::formats::{Cdc7600, Double, Extended, Format, IbmShort, Single};
use geometry_core::tolerance::soft::{Rounding, Soft};
use geometry_core::{Kernel2, Sign, Tolerance};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn number(rng: &mut ChaCha8Rng) -> f64 {
    match rng.random_range(0..8) {
        0 => 0.0,
        1 => f64::from(rng.random_range(-9..10)),
        _ => (rng.random::<f64>() - 0.5) * 2_f64.powi(rng.random_range(-20..20)),
    }
}

#[test]
fn soft_binary64_and_binary32_are_the_hardware_formats() {
    type Binary64 = Soft<2, 53, { Rounding::NEAREST }>;
    type Binary32 = Soft<2, 24, { Rounding::NEAREST }>;
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for _ in 0..500_000 {
        let (x, y) = (number(&mut rng), number(&mut rng));
        assert_eq!(
            Binary64::of(x).minus(Binary64::of(y)).to_f64(),
            x - y,
            "{x:?} - {y:?}"
        );
        assert_eq!(
            Binary64::of(x).times(Binary64::of(y)).to_f64(),
            x * y,
            "{x:?} * {y:?}"
        );
        assert_eq!(
            Binary64::of(x).plus(Binary64::of(y)).to_f64(),
            x + y,
            "{x:?} + {y:?}"
        );
        let quotient = Binary64::of(x).over(Binary64::of(y)).map(Binary64::to_f64);
        assert_eq!(quotient, (y != 0.0).then(|| x / y), "{x:?} / {y:?}");
        let root = Binary64::of(x).root().map(Binary64::to_f64);
        assert_eq!(root, (x >= 0.0).then(|| x.sqrt()), "root of {x:?}");
        let (s, t) = (x as f32, y as f32);
        let quotient = Binary32::of(s.into()).over(Binary32::of(t.into()));
        assert_eq!(
            quotient.map(Binary32::to_f64),
            (t != 0.0).then(|| f64::from(s / t)),
            "{s:?} / {t:?}"
        );
        let root = Binary32::of(s.into()).root().map(Binary32::to_f64);
        assert_eq!(
            root,
            (s >= 0.0).then(|| f64::from(s.sqrt())),
            "root of {s:?}"
        );
        assert_eq!(Binary32::of(x).to_f64(), f64::from(s), "{x:?}");
        assert_eq!(
            Binary32::of(x).minus(Binary32::of(y)).to_f64(),
            f64::from(s - t),
            "{s:?} - {t:?}"
        );
        assert_eq!(
            Binary32::of(x).times(Binary32::of(y)).to_f64(),
            f64::from(s * t),
            "{s:?} * {t:?}"
        );
    }
}

#[test]
fn ibm_short_truncates_to_six_hexadecimal_digits() {
    // 0.1 = 0.1999 99|99… in base 16.
    assert_eq!(
        IbmShort::of(0.1).to_f64(),
        f64::from(0x199999) / f64::from(1 << 24)
    );
    // A leading hexadecimal digit of 1 leaves 21 significant bits, one of 8 or more leaves 24.
    let one_and_a_bit = 1.0 + 2_f64.powi(-21);
    assert_eq!(IbmShort::of(one_and_a_bit).to_f64(), 1.0);
    let fifteen_and_a_bit = 15.0 + 2_f64.powi(-20);
    assert_eq!(IbmShort::of(fifteen_and_a_bit).to_f64(), fifteen_and_a_bit);
}

#[test]
fn ibm_short_keeps_one_guard_digit() {
    let digit = |n: i32| 16_f64.powi(n);
    let difference = |x: f64, y: f64| IbmShort::of(x).minus(IbmShort::of(y)).to_f64();
    // 1 - 0.FFFFFF: the guard digit keeps what the shift moves out.
    assert_eq!(difference(1.0, 1.0 - digit(-6)), digit(-6));
    // 1 - 0.0FFFFFF: two digits move out, one is kept, so the result is one unit too large.
    let exact = 1.0 - (digit(-1) - digit(-7));
    let truncated = (exact / digit(-6)).floor() * digit(-6);
    assert_eq!(
        difference(1.0, digit(-1) - digit(-7)),
        truncated + digit(-6)
    );
}

#[test]
fn cdc_truncates_to_48_bits_and_extended_rounds_to_64() {
    let tenth = 0.1_f64;
    let kept = (tenth * 2_f64.powi(51)).floor() / 2_f64.powi(51);
    assert_eq!(Cdc7600::of(tenth).to_f64(), kept);
    // (1 + 2^-40)² = 1 + 2^-39 + 2^-80: cut to 48 bits without and to 64 bits with nothing to round.
    let x = 1.0 + 2_f64.powi(-40);
    assert_eq!(
        Cdc7600::of(x).times(Cdc7600::of(x)).to_f64(),
        1.0 + 2_f64.powi(-39)
    );
    // 1 - 2^-60 and back: lost in 53 bits, kept in 64.
    let near_one = Extended::of(1.0).minus(Extended::of(2_f64.powi(-60)));
    assert_eq!(Extended::of(1.0).minus(near_one).to_f64(), 2_f64.powi(-60));
    let near_one = Double::of(1.0).minus(Double::of(2_f64.powi(-60)));
    assert_eq!(Double::of(1.0).minus(near_one).to_f64(), 0.0);
}

#[test]
fn quotients_and_roots_of_the_old_machines_are_truncated() {
    // 2/3 = 0.AAAAAA|AA… in base 16, and 0.101010… in base 2.
    let of = |numerator: f64, denominator: f64| {
        let quotient = IbmShort::of(numerator).over(IbmShort::of(denominator));
        quotient.expect("not by zero").to_f64()
    };
    assert_eq!(of(2.0, 3.0), f64::from(0xAA_AAAA) / f64::from(1 << 24));
    let third = Cdc7600::of(1.0).over(Cdc7600::of(3.0)).expect("not zero");
    assert_eq!(
        third.to_f64(),
        (2_f64.powi(49) / 3.0).floor() / 2_f64.powi(49)
    );
    // The root of 2 to 48 bits and to 64.
    let root = Cdc7600::of(2.0).root().expect("not negative").to_f64();
    assert_eq!(
        root,
        (2_f64.sqrt() * 2_f64.powi(47)).floor() / 2_f64.powi(47)
    );
    let root = Extended::of(2.0).root().expect("not negative");
    let rest = Extended::of(2.0).minus(root.times(root)).to_f64();
    assert!(rest.abs() <= 2_f64.powi(-62), "{rest:e}");
    let seventh = Extended::of(1.0).over(Extended::of(7.0)).expect("not zero");
    let rest = Extended::of(1.0).minus(seventh.times(Extended::of(7.0)));
    assert!(rest.to_f64().abs() <= 2_f64.powi(-64));
    assert!(Extended::of(1.0).over(Extended::of(0.0)).is_none());
    assert!(Extended::of(-1.0).root().is_none());
}

#[test]
fn areas_below_epsilon_are_zero_and_no_others() {
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.25]]; // area 0.125 in every format
    fn sign<F: Format>(epsilon: f64, [a, b, c]: [[f64; 2]; 3]) -> Sign {
        Tolerance::<F>::new(epsilon).orient(a, b, c)
    }
    for (epsilon, expected) in [
        (0.0, Sign::Positive),
        (0.125, Sign::Positive),
        (0.126, Sign::Zero),
    ] {
        assert_eq!(sign::<Single>(epsilon, triangle), expected);
        assert_eq!(sign::<Double>(epsilon, triangle), expected);
        assert_eq!(sign::<Extended>(epsilon, triangle), expected);
        assert_eq!(sign::<IbmShort>(epsilon, triangle), expected);
        assert_eq!(sign::<Cdc7600>(epsilon, triangle), expected);
    }
}

#[test]
fn a_short_format_sees_a_turn_where_there_is_none() {
    let row = [[0.1, 0.1], [0.2, 0.2], [0.7, 0.7]];
    let kernel = Tolerance::<Single>::new(0.0);
    let answers = row.map(|p| kernel.orient([0.3, 0.1], [1.3, 1.1], [p[0] + 0.2, p[1]]));
    assert!(
        answers.iter().any(|sign| !sign.is_zero()),
        "rounding to 24 bits should bend the row: {answers:?}"
    );
}
