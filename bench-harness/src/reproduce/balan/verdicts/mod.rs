//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod b1;
mod b2;
mod b3;
mod b4;
mod b5;
mod b6;
mod b7;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

use super::Balan;
use crate::reproduce::paper::Claim;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of, verdict};

/// The claims, in order.
pub(crate) const CLAIMS: &[Claim<Balan>] = &[
    Claim::new("B-1", &["balan-counts", "merges"], |records, _| {
        b1::judge(records)
    }),
    Claim::new("B-2", &["angles"], |records, _| b2::judge(records)),
    Claim::new("B-3", &["balan-counts"], |records, _| b3::judge(records)),
    Claim::new("B-4", &["balan-counts"], |records, _| b4::judge(records)),
    Claim::new("B-5", &["orders"], |records, _| b5::judge(records)),
    Claim::new("B-6", &["balan-counts"], |records, _| b6::judge(records)),
    Claim::new("B-7", &["balan-times"], |records, _| b7::judge(records)),
];
