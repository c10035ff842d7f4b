//! Points in lexicographic order, by keys of one word.
//!
//! ```text
//!     key   [ x as a fixed-point number, rounded down | place of the point ]
//!             64 - b bits                               b bits, as many as places need
//! ```
//!
//! The fixed-point number is a monotone function of x (each of its roundings is), so sorting keys sorts points but for
//! runs of equal numbers, which are then sorted by comparison. Words sort faster than points or indices, and many of
//! them need not be compared at all: two passes of a radix sort order them by their first 22 bits.

use geometry_core::Point2;
use geometry_core::kernel::lexicographic;

/// A list at least this long is sorted by its digits first.
const LONG: usize = 2048;

/// Bits of a digit.
const DIGIT: u32 = 11;

/// Makes and reads the keys of the points of one set.
#[derive(Clone, Copy)]
pub(super) struct Keys {
    least: f64,
    scale: f64,
    most: u64,
    place_bits: u32,
}

impl Keys {
    /// For `count` points with x in `least..=most`.
    pub(super) fn new(count: usize, least: f64, most: f64) -> Self {
        let place_bits = usize::BITS - count.leading_zeros();
        let width = 63 - place_bits;
        Self {
            least,
            // Infinite, zero or NaN for extreme ranges: then many numbers are equal.
            scale: (1_u64 << width) as f64 / (most - least),
            most: (1 << width) - 1,
            place_bits,
        }
    }

    /// The key of the point at `place`.
    #[inline(always)]
    pub(super) fn key(self, x: f64, place: usize) -> u64 {
        // NaN becomes 0, which any x equal to the least has, and the others are not less.
        let number = ((x - self.least) * self.scale) as i64 as u64;
        number.min(self.most) << self.place_bits | place as u64
    }

    /// The place of the point with this key.
    #[inline(always)]
    pub(super) fn place(self, key: u64) -> usize {
        (key & ((1 << self.place_bits) - 1)) as usize
    }

    fn number(self, key: u64) -> u64 {
        key >> self.place_bits
    }

    /// Sorts the keys by their points, and moves to the front one key for each distinct point, that of the first place.
    /// Returns how many.
    pub(super) fn sort(self, points: &[Point2], keys: &mut [u64]) -> usize {
        if keys.len() < LONG {
            keys.sort_unstable();
        } else {
            self.sort_long(keys);
        }
        self.order_runs(points, keys);
        let mut distinct = 0;
        for place in 0..keys.len() {
            let key = keys[place];
            let point = |key| points[self.place(key)];
            if distinct == 0 || point(keys[distinct - 1]) != point(key) {
                keys[distinct] = key;
                distinct += 1;
            }
        }
        distinct
    }

    /// Two passes of a radix sort, then comparisons of those whose digits are equal.
    fn sort_long(self, keys: &mut [u64]) {
        let mut scratch = vec![0; keys.len()];
        // The highest bit of a key is never set.
        let high = u64::BITS - 1 - DIGIT;
        distribute(keys, &mut scratch, high - DIGIT);
        distribute(&scratch, keys, high);
        for run in keys.chunk_by_mut(|a, b| a >> (high - DIGIT) == b >> (high - DIGIT)) {
            run.sort_unstable();
        }
    }

    /// Sorts runs of keys whose numbers are equal.
    fn order_runs(self, points: &[Point2], keys: &mut [u64]) {
        for run in keys.chunk_by_mut(|&a, &b| self.number(a) == self.number(b)) {
            if run.len() > 1 {
                run.sort_unstable_by(|&a, &b| {
                    let [p, q] = [a, b].map(|key| points[self.place(key)]);
                    lexicographic(p, q).then(a.cmp(&b))
                });
            }
        }
    }
}

/// Copies the keys `from` to `to` in the stable order of the digit that begins at bit `shift`.
fn distribute(from: &[u64], to: &mut [u64], shift: u32) {
    const DIGITS: usize = 1 << DIGIT;
    let digit = |key: u64| (key >> shift) as usize % DIGITS;
    let mut starts = [0_u32; DIGITS];
    for &key in from {
        starts[digit(key)] += 1;
    }
    let mut sum = 0;
    for start in &mut starts {
        sum += std::mem::replace(start, sum);
    }
    for &key in from {
        let start = &mut starts[digit(key)];
        to[*start as usize] = key;
        *start += 1;
    }
}
