//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod d1;
mod d10;
mod d11;
mod d2;
mod d3;
mod d4;
mod d5;
mod d6;
mod d7;
mod d8;
mod d9;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

use super::Day;
use crate::reproduce::paper::Claim;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of, always, verdict};
use crate::stats::wilson;

/// The claims, in order.
pub(crate) const CLAIMS: &[Claim<Day>] = &[
    Claim::new("D-1", &["precision"], |records, _| d1::judge(records)),
    Claim::new("D-2", &["speed"], |records, _| d2::judge(records)),
    Claim::new("D-3", &["merges"], |records, _| d3::judge(records)),
    Claim::new("D-4", &["merges"], |records, _| d4::judge(records)),
    Claim::new("D-5", &["merges"], |records, _| d5::judge(records)),
    Claim::new("D-6", &["bases"], |records, _| d6::judge(records)),
    Claim::new(
        "D-7",
        &["day-counts", "turned", "day-times"],
        |records, _| d7::judge(records),
    ),
    Claim::new("D-8", &["battery"], |records, _| d8::judge(records)),
    Claim::new("D-9", &["listing"], |records, _| d9::judge(records)),
    Claim::new("D-10", &["checks"], |records, _| d10::judge(records)),
    Claim::new("D-11", &["parallel", "day-times"], |records, _| {
        d11::judge(records)
    }),
];

/// "k of n, share [Wilson's interval]".
fn share(hits: usize, trials: usize) -> String {
    let (low, high) = wilson::interval(hits, trials);
    format!(
        "{hits} of {trials}, {:.3} [{low:.3}, {high:.3}]",
        hits as f64 / trials.max(1) as f64
    )
}
