//! Every predicate of the exact kernel against big integers, on a million inputs each.
//!
//! The inputs are of the classes of [`inputs::Class`], in shares chosen so that most questions are hard: on or
//! within two ulps of a line, circle or plane, on grids, at all magnitudes from the least subnormal number to the
//! largest finite one. The reference ([`reference`]) knows only the bits of the coordinates.

mod inputs;
mod reference;

use geometry_core::exact::{Boxed, Unit};
use geometry_core::{Axis, Exact, InCircle, Kernel2, Kernel3, Lifted, Point2, Sign, Stage};
use inputs::{Class, Inputs, SHARES};
use std::fmt::Debug;

/// Asks `kernel` about a million inputs and compares with `reference`. `near` makes the degenerate inputs, to be
/// moved by an ulp or two.
fn compare<const D: usize, const N: usize, A: PartialEq + Debug>(
    seed: u64,
    near: impl Fn(&mut Inputs) -> [[f64; D]; N],
    kernel: impl Fn(&[[f64; D]; N]) -> (A, Stage),
    reference: impl Fn(&[[f64; D]; N]) -> Sign,
    answer: impl Fn(Sign) -> A,
) {
    let mut inputs = Inputs::new(seed);
    let (mut asked, mut hard, mut signs) = (0, 0, [0; 3]);
    for (class, share) in SHARES {
        for number in 0..share {
            let points: [[f64; D]; N] = inputs.points(class, &near);
            let (found, stage) = kernel(&points);
            let expected = reference(&points);
            asked += 1;
            hard += u32::from(stage != Stage::Filter);
            signs[(expected as i8 + 1) as usize] += 1;
            assert_eq!(
                found,
                answer(expected),
                "seed {seed}, {class:?} number {number} ({stage:?}): {points:?}\nbits: {:#018x?}",
                points.map(|p| p.map(f64::to_bits))
            );
        }
    }
    assert_eq!(asked, 1_000_000);
    // The inputs are worth asking about: many beyond the filter, and every answer often right.
    assert!(hard > 200_000, "only {hard} questions were hard");
    assert!(signs.iter().all(|&count| count > 20_000), "{signs:?}");
}

/// The kernels for the smallest box around `points`, and for a larger one, with and without their unit.
fn boxes(points: &[Point2]) -> impl Iterator<Item = Boxed> + use<> {
    let [width, height] = [0, 1].map(|axis| {
        let values = || points.iter().map(|p| p[axis]);
        values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
    });
    let units = [Unit::of(points), Unit::UNKNOWN];
    units.into_iter().flat_map(move |unit| {
        [1.0, 16.0].map(|factor| Boxed::new(width * factor, height * factor, unit))
    })
}

#[test]
fn orientation() {
    compare(
        101,
        |inputs| {
            let [a, b] = [inputs.anywhere(), inputs.anywhere()];
            [a, b, inputs.on_line(a, b)]
        },
        |&[a, b, c]| {
            let (sign, stage) = Exact.orient_staged(a, b, c);
            assert_eq!(Exact.orient(a, b, c), sign);
            for kernel in boxes(&[a, b, c]) {
                assert_eq!(kernel.orient(a, b, c), sign, "{kernel:?}");
            }
            (sign, stage)
        },
        |&[a, b, c]| reference::cross(a, b, a, c),
        |sign| sign,
    );
}

#[test]
fn comparison_of_distances() {
    compare(
        102,
        |inputs| {
            let [a, b, p] = [inputs.anywhere(), inputs.anywhere(), inputs.anywhere()];
            let along = inputs.on_line([0.0, 0.0], [b[0] - a[0], b[1] - a[1]]);
            [a, b, p, [p[0] + along[0], p[1] + along[1]]]
        },
        |&[a, b, p, q]| {
            let (ordering, stage) = Exact.compare_distance_staged(a, b, p, q);
            assert_eq!(Exact.compare_distance(a, b, p, q), ordering);
            (ordering, stage)
        },
        // p is further to the left than q if going from q to p leads to the left.
        |&[a, b, p, q]| reference::cross(a, b, q, p),
        Sign::ordering,
    );
}

#[test]
fn in_circle() {
    compare(
        103,
        Inputs::on_circle,
        |&[a, b, c, d]| {
            let (sign, stage) = Exact.in_circle_staged(a, b, c, d);
            assert_eq!(Exact.in_circle(a, b, c, d), sign);
            for kernel in boxes(&[a, b, c, d]) {
                assert_eq!(kernel.in_circle(a, b, c, d), sign, "{kernel:?}");
            }
            (sign, stage)
        },
        reference::in_circle,
        |sign| sign,
    );
}

#[test]
fn orientation_in_space() {
    compare(
        104,
        |inputs| {
            let [a, b, c] = [inputs.anywhere(), inputs.anywhere(), inputs.anywhere()];
            [a, b, c, inputs.on_plane(a, b, c)]
        },
        |&[a, b, c, d]| {
            let (sign, stage) = Exact.orient3_staged(a, b, c, d);
            assert_eq!(Exact.orient3(a, b, c, d), sign);
            (sign, stage)
        },
        reference::orient_in_space,
        |sign| sign,
    );
}

#[test]
fn comparison_of_heights() {
    compare(
        106,
        |inputs| {
            let [a, b, c] = [inputs.anywhere(), inputs.anywhere(), inputs.anywhere()];
            let [p, on]: [[f64; 3]; 2] = [inputs.anywhere(), inputs.on_plane(a, b, c)];
            [a, b, c, p, [0, 1, 2].map(|i| p[i] + (on[i] - a[i]))]
        },
        |&[a, b, c, p, q]| Exact.compare_height_staged([a, b, c], p, q),
        reference::height_difference,
        Sign::ordering,
    );
}

/// The points given to a lifting kernel, whose third coordinates it must not look at.
fn in_space<const N: usize>(points: &[[f64; 2]; N]) -> [[f64; 3]; N] {
    points.map(|[x, y]| [x, y, f64::MAX])
}

#[test]
fn comparison_of_heights_of_lifted_points() {
    compare(
        107,
        |inputs| {
            let [a, b, c, d] = inputs.on_circle();
            [a, b, c, d, b]
        },
        |points| {
            let [a, b, c, p, q] = in_space(points);
            Lifted(Exact).compare_height_staged([a, b, c], p, q)
        },
        reference::lifted_height_difference,
        Sign::ordering,
    );
}

#[test]
fn shadows_of_lifted_points() {
    // Along z the shadows are the points themselves.
    for (seed, axis) in [(108, Axis::X), (109, Axis::Y)] {
        compare(
            seed,
            |inputs| {
                // Two points, mirrored so that their shadows are one.
                let [[x, y], c] = [inputs.anywhere(), inputs.anywhere()];
                let image = if axis == Axis::X { [-x, y] } else { [x, -y] };
                [[x, y], image, c]
            },
            |points| {
                let [a, b, c] = in_space(points);
                Lifted(Exact).shadow_staged(axis, a, b, c)
            },
            |points| reference::lifted_shadow(points, axis),
            |sign| sign,
        );
    }
}

#[test]
fn the_reference_knows_the_conventions() {
    let [o, x, y] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(reference::cross(o, x, o, y), Sign::Positive);
    assert_eq!(reference::cross(o, y, o, x), Sign::Negative);
    assert_eq!(reference::in_circle(&[o, x, y, [0.5, 0.5]]), Sign::Positive);
    assert_eq!(reference::in_circle(&[o, x, y, [1.0, 1.0]]), Sign::Zero);
    assert_eq!(reference::in_circle(&[o, x, y, [1.0, 2.0]]), Sign::Negative);
    let [o, x, y, z] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(reference::orient_in_space(&[o, x, y, z]), Sign::Positive);
    assert_eq!(reference::orient_in_space(&[o, x, y, x]), Sign::Zero);
    assert_eq!(reference::orient_in_space(&[o, y, x, z]), Sign::Negative);
}

#[test]
fn the_inputs_reach_both_ends_of_the_range() {
    let mut inputs = Inputs::new(105);
    let near = |inputs: &mut Inputs| [inputs.anywhere::<2>(); 3];
    let mut magnitudes: Vec<f64> = Vec::new();
    for (class, _) in SHARES {
        for _ in 0..2000 {
            let points: [[f64; 2]; 3] = inputs.points(class, &near);
            let all = points.as_flattened().iter();
            assert!(all.clone().all(|x| x.is_finite()), "{class:?}: {points:?}");
            magnitudes.extend(all.map(|x| x.abs()).filter(|&x| x > 0.0));
        }
    }
    let least = magnitudes.iter().copied().fold(f64::MAX, f64::min);
    let largest = magnitudes.iter().copied().fold(0.0, f64::max);
    assert!(
        least < 1e-320 && largest > 1e308,
        "{least:?} to {largest:?}"
    );
    assert!(SHARES.iter().any(|&(class, _)| class == Class::AnyBits));
}
