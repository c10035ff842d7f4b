//! D-11: whether the method lends itself to several processors.

use super::{Outcome, Part, Verdict, always, verdict};
use crate::records::rows::twin;
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::Records;
use crate::reproduce::day::studies::METHOD;
use crate::reproduce::day::studies::PARALLEL;
use crate::reproduce::ratio::time_ratio;
use crate::reproduce::verdict::ratio_text;

pub(super) fn judge(records: &Records) -> Verdict {
    let rows = &records.own.parallel;
    let wrong = rows.iter().filter(|row| !row.same_hull).count();
    let more = rows
        .iter()
        .filter(|row| row.sequential != row.parallel)
        .count();
    let mut parts = vec![
        Part::new(
            "side by side gives the certified hull",
            at_all(wrong, rows.len()),
            format!("not so on {wrong} of {} sets", rows.len()),
        ),
        Part::new(
            "and asks the same number of questions",
            at_all(more, rows.len()),
            format!("not so on {more} of {} sets", rows.len()),
        ),
    ];
    let names = in_order(records.times.iter().map(|row| &row.distribution));
    parts.extend(names.iter().filter_map(|name| faster(records, name)));
    if names.is_empty() {
        parts.push(Part::new("it is faster", Outcome::NotTestable, "not timed"));
    }
    verdict("D-11", parts, notes(records, &names))
}

/// What is computed alike on every run needs no hundred cases, only some.
fn at_all(against: usize, cases: usize) -> Outcome {
    match always(against, cases) {
        Outcome::NotDistinguishable => Outcome::Confirmed,
        other => other,
    }
}

fn sizes(records: &Records, distribution: &str) -> Vec<usize> {
    let rows = records.times.iter();
    let own = rows.filter(|row| row.distribution == distribution && row.method == PARALLEL);
    let mut sizes: Vec<usize> = own.map(|row| row.n).collect();
    sizes.sort_unstable();
    sizes.dedup();
    sizes
}

/// Whether all processors are faster than one at the largest n.
fn faster(records: &Records, distribution: &str) -> Option<Part> {
    let n = *sizes(records, distribution).last()?;
    let ratio = time_ratio(&records.times, (distribution, n), PARALLEL, METHOD)?;
    let (low, high) = ratio.interval(0.95);
    let outcome = if high < 0.0 {
        Outcome::Confirmed
    } else if low > 0.0 {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    Some(Part::new(
        format!("{distribution}, n = {n}: faster on this machine's processors than on one"),
        outcome,
        format!("time ratio {}", ratio_text(ratio.median, (low, high))),
    ))
}

fn notes(records: &Records, names: &[&str]) -> Vec<String> {
    let note = |name: &&str| {
        let ratio = |n: usize, method: &str| {
            let ratio = time_ratio(&records.times, (name, n), method, METHOD)?;
            Some(format!("{n}: {:.3}", ratio.median.exp()))
        };
        let by_size = |method: &str| -> Vec<String> {
            let sizes = sizes(records, name);
            sizes.into_iter().filter_map(|n| ratio(n, method)).collect()
        };
        format!(
            "{name}, time side by side over one after the other, by n: {} (up to 4096 points there is nothing side by side); \
             one against itself: {}",
            by_size(PARALLEL).join(", "),
            by_size(&twin(METHOD)).join(", ")
        )
    };
    names.iter().map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::day::records::ParallelRow;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |factor: f64, same_hull, parallel| {
            let mut records = Records::default();
            records.own.parallel.push(ParallelRow {
                same_hull,
                sequential: 100,
                parallel,
                ..ParallelRow::default()
            });
            made_up::times(&mut records, &["sphere"], |n| n * n.ln(), factor);
            judge(&records).outcome
        };
        assert_eq!(judged(0.7, true, 100), Outcome::Confirmed);
        assert_eq!(judged(1.3, true, 100), Outcome::Refuted);
        assert_eq!(judged(0.7, false, 100), Outcome::Refuted);
        assert_eq!(judged(0.7, true, 101), Outcome::Refuted);
        assert_eq!(judged(1.0, true, 100), Outcome::NotDistinguishable);
    }
}
