//! The order in which points are inserted.

use geometry_core::sort::merge_sort;
use geometry_core::{Kernel3, Points};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The order in which points are inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// By index. An order chosen badly makes any incremental method slow.
    AsGiven,
    /// Shuffled, every order as likely as any other: Fisher and Yates's shuffle with numbers from ChaCha with 8 rounds.
    /// The same seed gives the same order everywhere.
    Shuffled {
        /// What the generator is started with.
        seed: u64,
    },
}

/// The seed of the methods that are not given one.
pub const DEFAULT_SEED: u64 = 1989;

impl Default for Order {
    /// Shuffled with [`DEFAULT_SEED`].
    fn default() -> Self {
        Order::Shuffled { seed: DEFAULT_SEED }
    }
}

impl Order {
    /// The distinct points in this order; of copies the one with the smallest index.
    ///
    /// O(n log n) comparisons to tell copies, which a shuffle would bring in any order.
    pub(crate) fn of<K: Kernel3>(self, points: Points<'_, 3>, kernel: &K) -> Vec<u32> {
        let mut ids: Vec<u32> = points.ids().collect();
        let mut scratch = vec![0; ids.len()];
        merge_sort(&mut ids, &mut scratch, |p, q| {
            kernel.lexicographic3(points[p], points[q])
        });
        // The sort is stable, so the first of a row of copies has the smallest index.
        ids.dedup_by(|later, kept| kernel.lexicographic3(points[*later], points[*kept]).is_eq());
        ids.sort_unstable();
        if let Order::Shuffled { seed } = self {
            shuffle(&mut ids, seed);
        }
        ids
    }
}

/// From the end, each is exchanged with one of those up to it.
fn shuffle(ids: &mut [u32], seed: u64) {
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    for last in (1..ids.len()).rev() {
        // The integer part of (last + 1) · x for x uniform in [0, 1); off uniform by less than 2⁻³².
        let product = u128::from(generator.next_u64()) * (last as u128 + 1);
        ids.swap(last, (product >> 64) as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::{Exact, HullError};

    #[test]
    fn copies_are_left_out_and_nothing_else() -> Result<(), HullError> {
        let points = [[1.0; 3], [0.0; 3], [1.0; 3], [2.0; 3], [-0.0; 3]];
        let points = Points::new(&points)?;
        assert_eq!(Order::AsGiven.of(points, &Exact), [0, 1, 3]);
        for seed in 0..20 {
            let mut ids = Order::Shuffled { seed }.of(points, &Exact);
            ids.sort_unstable();
            assert_eq!(ids, [0, 1, 3]);
        }
        Ok(())
    }

    #[test]
    fn every_order_comes_up_equally_often() {
        let mut counts = [0_u32; 6];
        for seed in 0..6000 {
            let mut ids = [0, 1, 2];
            shuffle(&mut ids, seed);
            // 012 -> 0, 021 -> 1, 102 -> 2, 120 -> 3, 201 -> 4, 210 -> 5
            counts[2 * ids[0] as usize + usize::from(ids[1] > ids[2])] += 1;
        }
        // Five standard deviations of a count are 144.
        assert!(
            counts.iter().all(|count| count.abs_diff(1000) < 150),
            "{counts:?}"
        );
    }

    /// Orders are part of what a seed promises.
    #[test]
    fn a_seed_gives_the_same_order_everywhere() {
        let mut ids: Vec<u32> = (0..10).collect();
        shuffle(&mut ids, DEFAULT_SEED);
        assert_eq!(ids, [2, 5, 1, 7, 6, 8, 0, 3, 9, 4]);
    }
}
