//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

#[cfg(test)]
mod made_up;
mod n1;
mod n2;
mod n3;
mod n4;
mod n5;
mod n6;
mod n7;
mod n8;
pub(crate) mod predictions;

pub(crate) use n6::CELL_MARGIN;

use super::Nathan;
use super::records::{Records, WrapRow};
use crate::reproduce::paper::Claim;
use crate::reproduce::verdict::{Outcome, Part, Verdict, always, verdict};

/// The claims, in order.
pub(crate) const CLAIMS: &[Claim<Nathan>] = &[
    Claim::new("N-1", &["wraps"], |records, _| n1::judge(records)),
    Claim::new("N-2", &["wraps"], |records, _| n2::judge(records)),
    Claim::new("N-3", &["wraps"], |records, _| n3::judge(records)),
    Claim::new("N-4", &["starts"], |records, _| n4::judge(records)),
    Claim::new("N-5", &["epsilon"], |records, _| n5::judge(records)),
    Claim::new("N-6", &["corners"], |records, _| n6::judge(records)),
    Claim::new("N-7", &["lifting"], |records, _| n7::judge(records)),
    Claim::new("N-8", &["sweep"], |records, _| n8::judge(records)),
];

/// The wraps of one variant of sets in one order.
fn wraps<'a>(
    records: &'a Records,
    order: &'a str,
    variant: &'a str,
) -> impl Iterator<Item = &'a WrapRow> {
    let rows = records.own.wraps.iter();
    rows.filter(move |row| row.order == order && row.variant == variant)
}

/// The distributions of `rows`, each once, in the order of the alphabet.
fn distributions<'a>(rows: impl Iterator<Item = &'a WrapRow>) -> Vec<&'a str> {
    let mut names: Vec<&str> = rows.map(|row| row.distribution.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The distinct values, smallest first.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_unstable_by(f64::total_cmp);
    values.dedup();
    values
}
