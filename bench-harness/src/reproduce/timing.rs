//! Times, interleaved and warm.
//!
//! Every round takes one sample of every contestant on every realisation, the contestants in an order shuffled
//! anew, so that what disturbs the machine disturbs all of them. A contestant may take part twice, under two
//! names: that shows the noise of a program against itself.
//!
//! A realisation of small n is a batch of inputs, called in turn: called on one small input again and again, a
//! processor learns its branches by heart, and the time is that of no input it has not seen. The batch is
//! called as often as it takes for a sample to last a millisecond.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::time::{Duration, Instant};

/// A sample lasts at least this long.
const SHORTEST: Duration = Duration::from_millis(1);

/// What takes part: a name, and a call that must keep its result from being optimised away.
pub(crate) struct Contestant<'a, T> {
    name: String,
    call: &'a dyn Fn(&T),
    passes: u64,
}

impl<'a, T> Contestant<'a, T> {
    /// A contestant that will be warm: it is called on `inputs` until a sample is long enough.
    pub(crate) fn warm(name: impl Into<String>, call: &'a dyn Fn(&T), inputs: &[T]) -> Self {
        Self {
            name: name.into(),
            call,
            passes: passes_for_a_sample(call, inputs),
        }
    }

    /// The same contestant under another name.
    pub(crate) fn twin(&self, name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            call: self.call,
            passes: self.passes,
        }
    }
}

/// One sample.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    /// The contestant.
    pub(crate) name: String,
    /// The number of the batch of inputs.
    pub(crate) realisation: u64,
    pub(crate) round: u32,
    /// Calls in a row.
    pub(crate) calls: u64,
    pub(crate) nanoseconds: u64,
}

/// `rounds` rounds of samples of `contestants` on `realisations`.
pub(crate) fn interleave<T>(
    mut contestants: Vec<Contestant<'_, T>>,
    realisations: &[Vec<T>],
    rounds: u32,
    seed: u64,
) -> Vec<Sample> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut samples = Vec::new();
    for round in 0..rounds {
        for (realisation, inputs) in (0..).zip(realisations) {
            shuffle(&mut contestants, &mut random);
            for contestant in &contestants {
                let time = sample(contestant.call, inputs, contestant.passes);
                samples.push(Sample {
                    name: contestant.name.clone(),
                    realisation,
                    round,
                    calls: contestant.passes * inputs.len() as u64,
                    nanoseconds: time.as_nanos() as u64,
                });
            }
        }
    }
    samples
}

/// How many passes over the inputs take at least [`SHORTEST`], by doubling. Also warms up.
fn passes_for_a_sample<T>(call: &dyn Fn(&T), inputs: &[T]) -> u64 {
    let mut passes = 1;
    while !inputs.is_empty() && sample(call, inputs, passes) < SHORTEST {
        passes *= 2;
    }
    passes
}

fn sample<T>(call: &dyn Fn(&T), inputs: &[T], passes: u64) -> Duration {
    let start = Instant::now();
    for _ in 0..passes {
        for input in inputs {
            call(input);
        }
    }
    start.elapsed()
}

/// Random order (Fisher and Yates).
fn shuffle<T>(items: &mut [T], random: &mut ChaCha8Rng) {
    for last in (1..items.len()).rev() {
        items.swap(last, random.random_range(0..=last));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;

    #[test]
    fn every_contestant_is_sampled_in_every_round_on_every_realisation() {
        let sum = |n: &u64| {
            black_box((0..*n).map(black_box).sum::<u64>());
        };
        let realisations = vec![vec![1_000, 2_000], vec![3_000]];
        let first = Contestant::warm("sum", &sum, &realisations[0]);
        let twin = first.twin("twin");
        let samples = interleave(vec![first, twin], &realisations, 3, 5);
        assert_eq!(samples.len(), 2 * 2 * 3);
        let of_twin = samples.iter().filter(|sample| sample.name == "twin");
        let mut places: Vec<(u32, u64)> = of_twin.map(|s| (s.round, s.realisation)).collect();
        places.sort_unstable();
        assert_eq!(places, [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)]);
        assert!(samples.iter().all(|s| s.nanoseconds > 0 && s.calls > 0));
    }
}
