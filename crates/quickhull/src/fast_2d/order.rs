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

/// Longer runs of equal x are sorted by y with keys, too.
const FEW: usize = 16;

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
        Self::with_place_bits(usize::BITS - count.leading_zeros(), least, most)
    }

    fn with_place_bits(place_bits: u32, least: f64, most: f64) -> Self {
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
        self.sort_numbers(keys);
        self.order_runs(points, keys)
    }

    fn sort_numbers(self, keys: &mut [u64]) {
        if keys.len() < LONG {
            keys.sort_unstable();
        } else {
            self.sort_long(keys);
        }
    }

    /// Two passes of a radix sort, then comparisons of those whose digits are equal.
    fn sort_long(self, keys: &mut [u64]) {
        let mut scratch = vec![0; keys.len()];
        // The highest bit of a key is never set.
        let high = u64::BITS - 1 - DIGIT;
        distribute(keys, &mut scratch, high - DIGIT);
        distribute(&scratch, keys, high);
        for run in keys.chunk_by_mut(|a, b| a >> (high - DIGIT) == b >> (high - DIGIT)) {
            if run.len() > 1 {
                run.sort_unstable();
            }
        }
    }

    /// Sorts the runs of keys with equal numbers, and moves the keys of distinct points to the front. Returns how many.
    fn order_runs(self, points: &[Point2], keys: &mut [u64]) -> usize {
        let (mut start, mut distinct) = (0, 0);
        while start < keys.len() {
            let number = self.number(keys[start]);
            let run = keys[start..]
                .iter()
                .take_while(|&&key| self.number(key) == number);
            let end = start + run.count();
            if end - start > 1 {
                self.order_run(points, &mut keys[start..end]);
            }
            let first = distinct;
            for place in start..end {
                // Copies have equal numbers.
                let is_copy = distinct > first
                    && points[self.place(keys[distinct - 1])] == points[self.place(keys[place])];
                keys[distinct] = keys[place];
                distinct += usize::from(!is_copy);
            }
            start = end;
        }
        distinct
    }

    /// Sorts keys with equal numbers.
    #[cold]
    fn order_run(self, points: &[Point2], run: &mut [u64]) {
        let point = |key: u64| points[self.place(key)];
        let x = point(run[0])[0];
        if run.len() > FEW && run.iter().all(|&key| point(key)[0] == x) {
            return self.order_column(points, run);
        }
        run.sort_unstable_by(|&a, &b| lexicographic(point(a), point(b)).then(a.cmp(&b)));
    }

    /// Sorts keys of points with one x: by keys made of y, and those with equal numbers by comparison.
    fn order_column(self, points: &[Point2], run: &mut [u64]) {
        let y = |key: u64| points[self.place(key)][1];
        let least = run.iter().map(|&key| y(key)).fold(f64::INFINITY, f64::min);
        let most = run
            .iter()
            .map(|&key| y(key))
            .fold(f64::NEG_INFINITY, f64::max);
        let upward = Keys::with_place_bits(self.place_bits, least, most);
        let mut column: Vec<u64> = run
            .iter()
            .map(|&key| upward.key(y(key), self.place(key)))
            .collect();
        upward.sort_numbers(&mut column);
        for part in column.chunk_by_mut(|&a, &b| upward.number(a) == upward.number(b)) {
            if part.len() > 1 {
                part.sort_unstable_by(|&a, &b| {
                    let [p, q] = [a, b].map(|key| points[self.place(key)]);
                    lexicographic(p, q).then(a.cmp(&b))
                });
            }
        }
        // The points of a run have one number for x, so any of its keys will do for its high bits.
        let number = self.number(run[0]) << self.place_bits;
        for (key, &by_y) in run.iter_mut().zip(&column) {
            *key = number | self.place(by_y) as u64;
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
