//! Inputs to the predicates, by class.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// A kind of input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    /// Uniform in the unit cube: what a filter settles.
    Uniform,
    /// Small integers: many zeros.
    SmallGrid,
    /// Multiples of 0.1, rounded.
    DecimalGrid,
    /// Integers of 53 bits: differences are inexact.
    WideIntegers,
    /// Degenerate, rounded, and every coordinate moved by up to two ulps.
    NearDegenerate,
    /// The same, times a power of two anywhere in the range.
    NearDegenerateScaled,
    /// The same, far from the origin: few bits of the coordinates differ.
    NearDegenerateFar,
    /// The same, with some coordinates replaced by the least numbers there are.
    NearDegenerateWithTraces,
    /// Neighbouring numbers near 1/2 against points far along the diagonal.
    Classroom,
    /// Exponents that differ by up to 60.
    MixedExponents,
    /// Exponents anywhere from -1074 to 1023.
    AnyExponents,
    /// Any finite bits whatever.
    AnyBits,
    /// Multiples of the least subnormal number.
    Subnormal,
    /// Near the largest finite number, of both signs: differences overflow.
    Huge,
}

/// How many inputs of each class: a million in all. The classes whose coordinates span thousands of bits, where
/// the reference is slow, have the smaller shares.
pub(crate) const SHARES: [(Class, u32); 14] = [
    (Class::Uniform, 50_000),
    (Class::SmallGrid, 100_000),
    (Class::DecimalGrid, 100_000),
    (Class::WideIntegers, 50_000),
    (Class::NearDegenerate, 250_000),
    (Class::NearDegenerateScaled, 150_000),
    (Class::NearDegenerateFar, 80_000),
    (Class::NearDegenerateWithTraces, 20_000),
    (Class::Classroom, 60_000),
    (Class::MixedExponents, 50_000),
    (Class::AnyExponents, 20_000),
    (Class::AnyBits, 20_000),
    (Class::Subnormal, 25_000),
    (Class::Huge, 25_000),
];

/// A source of inputs.
pub(crate) struct Inputs {
    rng: ChaCha8Rng,
}

impl Inputs {
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            rng: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// N points of this class; `near` makes those that are to be nearly degenerate.
    pub(crate) fn points<const D: usize, const N: usize>(
        &mut self,
        class: Class,
        near: &impl Fn(&mut Self) -> [[f64; D]; N],
    ) -> [[f64; D]; N] {
        match class {
            Class::Uniform => self.each(|rng| rng.random()),
            Class::SmallGrid => self.each(|rng| f64::from(rng.random_range(-3..=3))),
            Class::DecimalGrid => self.each(|rng| 0.1 * f64::from(rng.random_range(-9..=9))),
            Class::WideIntegers => self.each(|rng| (rng.random::<i64>() >> 10) as f64),
            Class::NearDegenerate => self.nudged(near),
            Class::NearDegenerateScaled => self.scaled(near),
            Class::NearDegenerateFar => self.far(near),
            Class::NearDegenerateWithTraces => self.with_traces(near),
            Class::Classroom => self.classroom(),
            Class::MixedExponents => self.each(|rng| with_exponent(rng, -30..30)),
            Class::AnyExponents => self.each(|rng| with_exponent(rng, -1074..1024)),
            Class::AnyBits => self.each(any_bits),
            Class::Subnormal => self.each(|rng| f64::from(rng.random_range(-40..=40)) * 5e-324),
            Class::Huge => self.each(|rng| with_exponent(rng, 1020..1024)),
        }
    }

    /// A point with coordinates of a few to 53 bits, between -1 and 1.
    pub(crate) fn anywhere<const D: usize>(&mut self) -> [f64; D] {
        let bits = self.rng.random_range(2..=53);
        std::array::from_fn(|_| {
            let integer = self.rng.random::<i64>() >> (63 - bits);
            integer as f64 * 2.0_f64.powi(-bits)
        })
    }

    /// A point on the line through a and b, as nearly as plain arithmetic can.
    pub(crate) fn on_line(&mut self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        let t = self.place();
        std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
    }

    /// A point on the plane through a, b and c, as nearly as plain arithmetic can.
    pub(crate) fn on_plane(&mut self, a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> [f64; 3] {
        let (s, t) = (self.place(), self.place());
        std::array::from_fn(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]))
    }

    /// Four points on a circle, exactly or as nearly as plain arithmetic can.
    pub(crate) fn on_circle(&mut self) -> [[f64; 2]; 4] {
        match self.rng.random_range(0..3) {
            0 => {
                // The corners of a rectangle, exactly if its corners are numbers.
                let ([x, y], [u, v]) = (self.anywhere(), self.anywhere());
                [[x, y], [u, y], [u, v], [x, v]]
            }
            1 => {
                // Integer points on the circle of radius 65.
                let [cx, cy] = [0, 1].map(|_| f64::from(self.rng.random_range(-1000..1000)));
                let legs = [[0, 65], [16, 63], [25, 60], [33, 56], [39, 52]];
                std::array::from_fn(|_| {
                    let [mut x, mut y] = legs[self.rng.random_range(0..legs.len())].map(f64::from);
                    if self.rng.random() {
                        (x, y) = (y, x);
                    }
                    let signs = [0, 1].map(|_| if self.rng.random() { 1.0 } else { -1.0 });
                    [cx + signs[0] * x, cy + signs[1] * y]
                })
            }
            _ => {
                let (center, radius): ([f64; 2], f64) = (self.anywhere(), self.rng.random());
                std::array::from_fn(|_| {
                    let angle = TAU * self.rng.random::<f64>();
                    [
                        center[0] + radius * angle.cos(),
                        center[1] + radius * angle.sin(),
                    ]
                })
            }
        }
    }

    /// A parameter along a line: one half and other short fractions, or any.
    fn place(&mut self) -> f64 {
        match self.rng.random_range(0..4) {
            0 => 0.5,
            1 => f64::from(self.rng.random_range(-8..=8)) / 4.0,
            _ => self.rng.random_range(-2.0..2.0),
        }
    }

    fn each<const D: usize, const N: usize>(
        &mut self,
        coordinate: impl Fn(&mut ChaCha8Rng) -> f64,
    ) -> [[f64; D]; N] {
        std::array::from_fn(|_| std::array::from_fn(|_| coordinate(&mut self.rng)))
    }

    /// `near`, and in half of the cases some coordinates moved by one or two ulps; in random order.
    fn nudged<const D: usize, const N: usize>(
        &mut self,
        near: impl Fn(&mut Self) -> [[f64; D]; N],
    ) -> [[f64; D]; N] {
        let mut points = near(self);
        for i in (1..N).rev() {
            points.swap(i, self.rng.random_range(0..=i));
        }
        if self.rng.random() {
            return points;
        }
        points.map(|p| {
            p.map(|x| match self.rng.random_range(0..8) {
                0 => x.next_up(),
                1 => x.next_down(),
                2 => x.next_up().next_up(),
                3 => x.next_down().next_down(),
                _ => x,
            })
        })
    }

    fn scaled<const D: usize, const N: usize>(
        &mut self,
        near: impl Fn(&mut Self) -> [[f64; D]; N],
    ) -> [[f64; D]; N] {
        let exponent = self.rng.random_range(-1073..1018);
        // Coordinates of nearly degenerate points may reach 7, so 2^1018 is as far as they can go.
        let points = self
            .nudged(near)
            .map(|p| p.map(|x| times_power(x, exponent)));
        if self.rng.random() {
            points
        } else {
            self.nudged(|_| points)
        }
    }

    fn far<const D: usize, const N: usize>(
        &mut self,
        near: impl Fn(&mut Self) -> [[f64; D]; N],
    ) -> [[f64; D]; N] {
        let away: [f64; D] = std::array::from_fn(|_| with_exponent(&mut self.rng, 0..50));
        self.nudged(|inputs| near(inputs).map(|p| std::array::from_fn(|i| away[i] + p[i])))
    }

    fn with_traces<const D: usize, const N: usize>(
        &mut self,
        near: impl Fn(&mut Self) -> [[f64; D]; N],
    ) -> [[f64; D]; N] {
        self.nudged(near).map(|p| {
            p.map(|x| match self.rng.random_range(0..4) {
                0 => f64::from(self.rng.random_range(-2..=2)) * 5e-324,
                1 => 0.0,
                _ => x,
            })
        })
    }

    /// Half of the points near (1/2, …) in steps of an ulp, half on the diagonal.
    fn classroom<const D: usize, const N: usize>(&mut self) -> [[f64; D]; N] {
        std::array::from_fn(|_| {
            if self.rng.random() {
                std::array::from_fn(|_| {
                    0.5 + f64::from(self.rng.random_range(0..64)) * f64::EPSILON / 2.0
                })
            } else {
                [f64::from(self.rng.random_range(1..=48)) / 2.0; D]
            }
        })
    }
}

/// A number of either sign with 53 random bits (fewer if subnormal) and an exponent in `exponents`.
fn with_exponent(rng: &mut ChaCha8Rng, exponents: std::ops::Range<i32>) -> f64 {
    let significand: f64 = rng.random_range(1.0..2.0);
    let sign = if rng.random() { 1.0 } else { -1.0 };
    times_power(sign * significand, rng.random_range(exponents))
}

/// x · 2^exponent, for an exponent that no one power of two may have.
fn times_power(x: f64, exponent: i32) -> f64 {
    let half = exponent / 2;
    x * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
}

fn any_bits(rng: &mut ChaCha8Rng) -> f64 {
    loop {
        let x = f64::from_bits(rng.random());
        if x.is_finite() {
            return x;
        }
    }
}
