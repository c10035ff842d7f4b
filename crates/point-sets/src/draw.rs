//! Random draws that are the same bits on every machine.
//!
//! ChaCha8 gives the words. The steps from words to numbers are written out here, with correctly rounded
//! operations and `libm` alone, so that a new version of a library cannot change a point.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A stream of draws.
pub(crate) struct Draw {
    words: ChaCha8Rng,
    /// The second normal deviate of a pair, not yet handed out.
    spare: Option<f64>,
}

impl Draw {
    pub(crate) fn new(seed: u64) -> Self {
        Draw {
            words: ChaCha8Rng::seed_from_u64(seed),
            spare: None,
        }
    }

    /// Uniform on [0, 1), a multiple of 2⁻⁵³.
    pub(crate) fn unit(&mut self) -> f64 {
        const STEP: f64 = 1.0 / (1_u64 << 53) as f64;
        (self.words.next_u64() >> 11) as f64 * STEP
    }

    /// Uniform on the unit disc, with its squared distance from the centre: a point of the square around the
    /// disc, drawn again while it is outside (4/π draws on average).
    pub(crate) fn in_disc(&mut self) -> ([f64; 2], f64) {
        loop {
            // 2u - 1 is exact: a multiple of 2⁻⁵² below 1 in magnitude.
            let x = 2.0 * self.unit() - 1.0;
            let y = 2.0 * self.unit() - 1.0;
            let squared = x * x + y * y;
            if squared <= 1.0 {
                return ([x, y], squared);
            }
        }
    }

    /// Uniform on the unit ball, with its squared distance from the centre: a point of the cube around the ball,
    /// drawn again while it is outside (6/π draws on average).
    pub(crate) fn in_ball(&mut self) -> ([f64; 3], f64) {
        loop {
            let [x, y, z] = [(); 3].map(|()| 2.0 * self.unit() - 1.0);
            let squared = x * x + y * y + z * z;
            if squared <= 1.0 {
                return ([x, y, z], squared);
            }
        }
    }

    /// Uniform on the unit sphere, but for rounding: a point of the ball pushed out; points near the centre,
    /// whose direction is coarse, are drawn again.
    pub(crate) fn on_sphere(&mut self) -> [f64; 3] {
        loop {
            let (point, squared) = self.in_ball();
            if squared > 1e-4 {
                let distance = squared.sqrt();
                return point.map(|coordinate| coordinate / distance);
            }
        }
    }

    /// Standard normal, by the polar method of G. Marsaglia and T. A. Bray, A convenient method for
    /// generating normal variables, SIAM Review 6 (1964) 260–264.
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        loop {
            let ([x, y], squared) = self.in_disc();
            if squared > 0.0 {
                let stretch = (-2.0 * libm::log(squared) / squared).sqrt();
                self.spare = Some(y * stretch);
                return x * stretch;
            }
        }
    }

    /// Uniform on 0, 1, ..., `bound` - 1, by D. Lemire, Fast random integer generation in an interval, ACM
    /// Transactions on Modeling and Computer Simulation 29 (2019) article 3. `bound` is positive.
    pub(crate) fn below(&mut self, bound: u64) -> u64 {
        // The low words under 2⁶⁴ mod bound are the surplus of the smaller values.
        let surplus = bound.wrapping_neg() % bound;
        loop {
            let product = u128::from(self.words.next_u64()) * u128::from(bound);
            if product as u64 >= surplus {
                return (product >> 64) as u64;
            }
        }
    }

    /// Puts `items` in uniformly random order (Fisher and Yates).
    pub(crate) fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let chosen = self.below(last as u64 + 1) as usize;
            items.swap(last, chosen);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn below_reaches_every_value_equally() {
        let mut draw = Draw::new(1);
        let mut counts = [0_u32; 7];
        for _ in 0..70_000 {
            counts[draw.below(7) as usize] += 1;
        }
        // Standard deviation of a count: 93.
        assert!(
            counts.iter().all(|count| count.abs_diff(10_000) < 450),
            "{counts:?}"
        );
    }

    #[test]
    fn shuffles_are_uniform() {
        let mut draw = Draw::new(2);
        let mut counts = std::collections::BTreeMap::new();
        for _ in 0..24_000 {
            let mut items = [0, 1, 2, 3];
            draw.shuffle(&mut items);
            *counts.entry(items).or_insert(0_u32) += 1;
        }
        assert_eq!(counts.len(), 24);
        // Standard deviation of a count: 31.
        assert!(
            counts.values().all(|count| count.abs_diff(1000) < 155),
            "{counts:?}"
        );
    }
}
