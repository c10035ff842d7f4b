//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod gs1;
mod gs2;
mod gs3;
mod gs4;
mod gs5;
mod gs6;
mod gs7;
mod gs8;
mod gs9;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

pub(crate) use gs5::{limit_from_above, limit_from_below};

use super::GreenSilverman;
use crate::reproduce::paper::Claim;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of, ratio_text, verdict, with_time};

/// The claims, in order.
pub(crate) const CLAIMS: &[Claim<GreenSilverman>] = &[
    Claim::new("GS-1", &["gs-counts", "gs-times"], gs1::judge),
    Claim::new("GS-2", &["gs-sizes"], gs2::judge),
    Claim::new("GS-3", &["gs-counts", "gs-times"], gs3::judge),
    Claim::new("GS-4", &["gs-counts", "gs-times"], gs4::judge),
    Claim::new("GS-5", &["tolerance", "lattices"], gs5::judge),
    Claim::new("GS-6", &["gs-counts", "gs-times"], gs6::judge),
    Claim::new("GS-7", &["peels"], gs7::judge),
    Claim::new("GS-8", &["lattices"], gs8::judge),
    Claim::new("GS-9", &["peels"], gs9::judge),
];
