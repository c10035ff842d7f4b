//! Questions about recorded runs, each answered from the records alone: a pure function from runs to a value.
//!
//! | module | answers |
//! |---|---|
//! | [`cmp`] | how do the engines compare, case by case |
//! | [`rank`] | which engine is fastest over all cases |
//! | [`diff`] | what has changed between two runs |
//! | [`fit`] | by which law does a cost grow |
//! | [`table`] | times and counts in the layout of a paper |
//! | [`plot`] | growth and ratios as drawings |
//! | [`targets`] | do the fast methods take no longer than they are meant to |
//! | [`threads`] | what does the machine gain by several threads |
//! | [`published`] | how do times that others print compare with the same programs here |
//! | [`export`] | the times in formats that other tools read |
//! | [`band`] | how much does a program differ from itself |
//! | [`compare`] | two engines on one case, round by round |
//!
//! Every comparison is of logarithms, so that twice as slow and twice as fast are equally far from equal. Nothing is
//! claimed inside the A/A band. The number of vertices h stands beside every time.

pub mod band;
pub mod cmp;
pub mod compare;
pub mod diff;
pub mod export;
pub mod fit;
pub mod plot;
pub mod published;
pub mod rank;
pub mod table;
pub mod targets;
pub mod threads;

use crate::output::sheet::duration;
use crate::records::{Case, Run, Spread};

/// The median over the realisations of `engine` on `case` of the median time of a call, in nanoseconds.
pub(crate) fn typical_time(run: &Run, case: &Case, engine: &str) -> Option<f64> {
    use crate::stats::summary::median;
    let times = run.times(case, engine).iter();
    let medians: Vec<f64> = times
        .map(|realisation| median(&realisation.times()))
        .collect();
    (!medians.is_empty()).then(|| median(&medians))
}

/// A seed for the bootstrap that depends on nothing but what is compared (FNV-1a), so that an answer is the same
/// every time.
pub(crate) fn seed_of(parts: &[&str]) -> u64 {
    let bytes = parts.iter().flat_map(|part| part.bytes().chain([0]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

pub(crate) fn h_text(h: Option<Spread>) -> String {
    h.map_or_else(|| "?".to_owned(), |h| h.to_string())
}

pub(crate) fn time_text(nanoseconds: Option<f64>) -> String {
    nanoseconds.map_or_else(String::new, duration)
}

/// `1.234 [1.200, 1.270]` from logarithms.
pub(crate) fn ratio_text(log: f64, (low, high): (f64, f64)) -> String {
    format!("{:.3} [{:.3}, {:.3}]", log.exp(), low.exp(), high.exp())
}

pub(crate) fn text(value: Option<impl std::fmt::Display>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}
