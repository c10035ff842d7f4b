//! D-1: which formats are right at which eps2.

use super::{Outcome, Part, Verdict, share, verdict};
use crate::reproduce::day::derived::{
    DAYS_POWER, FORMATS, Setting, line_of_bits, powers, right_of, settings, threshold, thresholds,
};
use crate::reproduce::day::records::{PrecisionRow, Records};
use crate::stats::wilson;
use std::collections::BTreeSet;

/// From so large a share on, the program is consistently right.
const CONSISTENT: f64 = 0.95;

pub(super) fn judge(records: &Records) -> Verdict {
    let control = control(records);
    if control.outcome != Outcome::Confirmed {
        let control = Part {
            outcome: Outcome::NotTestable,
            ..control
        };
        return verdict("D-1", vec![control], Vec::new());
    }
    let mut parts = vec![control];
    parts.extend(
        sizes(records)
            .into_iter()
            .filter_map(|n| extended(records, n)),
    );
    for format in ["f32", "f64"] {
        parts.extend(shorter(records, format));
    }
    parts.push(order(records));
    parts.push(failures(records));
    verdict("D-1", parts, notes(records))
}

fn sizes(records: &Records) -> BTreeSet<usize> {
    records.own.precision.iter().map(|row| row.n).collect()
}

/// Whether exact orientations are right on every set that was tried, as rounded to any format.
fn control(records: &Records) -> Part {
    let what = "control: exact orientations on the same rounded points, every hull certified";
    let sum = |of: fn(&crate::reproduce::day::records::ControlRow) -> usize| -> usize {
        records.own.controls.iter().map(of).sum()
    };
    let (right, sets) = (sum(|row| row.right), sum(|row| row.sets));
    let outcome = match sets {
        0 => Outcome::NotTestable,
        _ if right == sets => Outcome::Confirmed,
        _ => Outcome::Refuted,
    };
    Part::new(what, outcome, share(right, sets))
}

/// The paper's own format at the paper's eps2: rows of size `n` at no offset.
fn extended(records: &Records, n: usize) -> Option<Part> {
    let rows = at_days_power(records, "extended").filter(|row| row.n == n);
    let (right, sets) = right_of(rows);
    let what = format!("extended, eps2 = 1e16, n = {n}: right, ranges pooled");
    (sets > 0).then(|| Part::new(what, above(right, sets), share(right, sets)))
}

fn at_days_power<'a>(
    records: &'a Records,
    format: &'a str,
) -> impl Iterator<Item = &'a PrecisionRow> {
    let rows = records.own.precision.iter();
    rows.filter(move |row| row.format == format && row.power == DAYS_POWER && row.offset == 0.0)
}

/// Whether the share is above what is consistent.
fn above(right: usize, sets: usize) -> Outcome {
    let (low, high) = wilson::interval(right, sets);
    if low > CONSISTENT {
        Outcome::Confirmed
    } else if high < CONSISTENT {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    }
}

/// A shorter format is not consistently right at the paper's eps2, and is at some smaller one, in the unit cube at the
/// smallest n.
fn shorter(records: &Records, format: &str) -> Vec<Part> {
    let plain = settings(records)
        .into_iter()
        .filter(|setting| setting.format == format && setting.is_plain());
    let Some(setting) = plain.min_by_key(|setting| setting.n) else {
        return Vec::new();
    };
    let rows = powers(records, setting);
    let n = setting.n;
    let (right, sets) = right_of(rows.iter().copied().filter(|row| row.power == DAYS_POWER));
    let fails = match above(right, sets) {
        Outcome::Confirmed => Outcome::Refuted,
        Outcome::Refuted => Outcome::Confirmed,
        other => other,
    };
    let fails = Part::new(
        format!("{format}, eps2 = 1e16, n = {n}: not consistently right"),
        fails,
        share(right, sets),
    );
    let smaller = rows
        .iter()
        .filter(|row| row.power < DAYS_POWER && row.sets > 0);
    // Many powers are tried, so the best of them is not taken: the middle of the run of good ones is.
    let good: Vec<&&PrecisionRow> = smaller
        .filter(|row| row.right as f64 > CONSISTENT * row.sets as f64)
        .collect();
    let what = format!("{format}, n = {n}: consistently right with some smaller eps2");
    let works = match good.get(good.len() / 2) {
        Some(row) => Part::new(
            what,
            above(row.right, row.sets),
            format!("eps2 = 1e{}: {}", row.power, share(row.right, row.sets)),
        ),
        None => Part::new(what, Outcome::Refuted, "at no power of ten"),
    };
    vec![fails, works]
}

/// Whether the largest good eps2 rises from the shortest format to the longest, by more than its error.
fn order(records: &Records) -> Part {
    let what = "the largest good eps2 rises with the bits: single, double, extended";
    let known: Option<Vec<(f64, f64)>> = FORMATS
        .iter()
        .map(|format| {
            let smallest = settings(records)
                .into_iter()
                .filter(|setting| setting.format == *format && setting.is_plain())
                .min_by_key(|setting| setting.n)?;
            let curve = threshold(records, smallest)?;
            Some((curve.half, curve.half_error))
        })
        .collect();
    let Some(known) = known else {
        return Part::new(what, Outcome::NotTestable, "not all three have one");
    };
    let apart = |pair: &[(f64, f64)]| {
        let ((low, a), (high, b)) = (pair[0], pair[1]);
        (high - low) / a.hypot(b)
    };
    let outcomes = known.windows(2).map(|pair| match apart(pair) {
        z if z > 1.96 => Outcome::Confirmed,
        z if z < -1.96 => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    });
    let text: Vec<String> = known
        .iter()
        .zip(FORMATS)
        .map(|((half, error), format)| format!("{format} 10^({half:.2} ± {:.2})", 1.96 * error))
        .collect();
    Part::new(what, super::all_of(outcomes), text.join(", "))
}

/// Whether all the kinds of failure that the paper names occur in single or double precision.
fn failures(records: &Records) -> Part {
    let short = |row: &&PrecisionRow| row.format == "f32" || row.format == "f64";
    let sum = |of: fn(&PrecisionRow) -> usize| -> usize {
        records.own.precision.iter().filter(short).map(of).sum()
    };
    let counts = [
        sum(|row| row.dangling),
        sum(|row| row.wrong),
        sum(|row| row.endless),
    ];
    let [dangling, wrong, endless] = counts;
    let outcome = if counts.iter().all(|&count| count > 0) {
        Outcome::Confirmed
    } else {
        Outcome::NotDistinguishable
    };
    Part::new(
        "in single or double: dangling links, wrong hulls and endless loops all occur",
        outcome,
        format!("{dangling} dangling, {wrong} wrong hulls, {endless} endless, over all eps2"),
    )
}

fn notes(records: &Records) -> Vec<String> {
    let mut notes = Vec::new();
    for n in sizes(records) {
        let found = thresholds(records, n);
        if !found.is_empty() {
            let text = found.iter().map(|(bits, half, error)| {
                format!("{bits} bits 10^({half:.2} ± {:.2})", 1.96 * error)
            });
            notes.push(format!(
                "unit cube, n = {n}: half of the sets are right at eps2 = {}",
                text.collect::<Vec<_>>().join(", ")
            ));
        }
    }
    notes.extend(by_size(records));
    if let Some((n, line)) = line_of_bits(records) {
        let (low, high) = line.slope_interval(0.95);
        notes.push(format!(
            "n = {n}: the threshold rises by {:.4} powers of ten a bit, 95 % [{low:.4}, {high:.4}]; doubling with every bit \
             would be 0.3010",
            line.slope
        ));
    }
    notes.extend(
        FORMATS
            .iter()
            .filter_map(|format| elsewhere(records, format)),
    );
    notes
}

/// How the threshold of double precision falls from the smallest to the largest n.
fn by_size(records: &Records) -> Option<String> {
    let mut plain: Vec<Setting<'_>> = settings(records)
        .into_iter()
        .filter(|setting| setting.format == "f64" && setting.is_plain())
        .collect();
    plain.sort_by_key(|setting| setting.n);
    let known =
        |setting: &Setting<'_>| Some((setting.n as f64, threshold(records, *setting)?.half));
    let known: Vec<(f64, f64)> = plain.iter().filter_map(known).collect();
    let ([(n, half), ..], [.., (more, lower)]) = (&known[..], &known[..]) else {
        return None;
    };
    (more > n).then(|| {
        format!(
            "f64: from n = {n} to {more} the threshold falls by {:.2} powers of ten for each one of n, so that no eps2 is good for \
             every n; the paper does not say how many points it tried",
            (half - lower) / (more / n).log10()
        )
    })
}

/// The thresholds of a format in other ranges and at other offsets.
fn elsewhere(records: &Records, format: &str) -> Option<String> {
    let smallest = records.own.precision.iter().map(|row| row.n).min()?;
    let text = |setting: Setting<'_>| {
        let found = threshold(records, setting).map_or_else(
            || "none".to_owned(),
            |curve| format!("10^{:.2}", curve.half),
        );
        format!("{:e} + {:e}: {found}", setting.range, setting.offset)
    };
    let cells: Vec<String> = settings(records)
        .into_iter()
        .filter(|setting| setting.format == format && setting.n == smallest)
        .map(text)
        .collect();
    (cells.len() > 1).then(|| {
        format!(
            "{format}, n = {smallest}, eps2 at which half are right, by range + offset (none: never more than half): {}",
            cells.join("; ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |halves: [f64; 3], control: usize| {
            let mut records = Records::default();
            made_up::precision(&mut records, halves, control);
            judge(&records)
        };
        let as_published = judged([6.5, 13.5, 18.5], 100);
        assert_eq!(as_published.outcome, Outcome::Confirmed, "{as_published:?}");
        // Extended fails at the paper's eps2.
        assert_eq!(judged([6.5, 13.5, 15.5], 100).outcome, Outcome::Refuted);
        // Double does not.
        assert_eq!(judged([6.5, 17.5, 18.5], 100).outcome, Outcome::Refuted);
        // The control is wrong once.
        assert_eq!(judged([6.5, 13.5, 18.5], 99).outcome, Outcome::NotTestable);
    }

    #[test]
    fn one_kind_of_failure_is_not_all() {
        let mut records = Records::default();
        made_up::precision(&mut records, [6.5, 13.5, 18.5], 100);
        for row in &mut records.own.precision {
            (row.wrong, row.endless) = (row.wrong + row.endless, 0);
        }
        assert_eq!(judge(&records).outcome, Outcome::NotDistinguishable);
    }
}
