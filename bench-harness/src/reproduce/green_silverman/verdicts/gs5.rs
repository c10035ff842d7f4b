//! GS-5: the limits of the tolerance in Table 1, and Eddy's method on the lattice.

use super::{Outcome, Part, Verdict, all_of, verdict};
use crate::reproduce::green_silverman::published::{Published, Threshold};
use crate::reproduce::green_silverman::records::{Records, ToleranceRow};
use crate::stats::wilson;

/// A printed limit of random data is that of one set: it is borne out if so many sets or more have it.
const ORDINARY: f64 = 0.05;

/// The rings of a 10 by 10 lattice.
pub(super) const RINGS: &str = "36 28 20 12 4";

pub(super) fn judge(records: &Records, published: &Published) -> Verdict {
    let mut notes = Vec::new();
    let mut parts: Vec<Part> = Vec::new();
    for row in &published.table1 {
        match row.data.as_str() {
            "random" => parts.push(random(records, row)),
            _ => {
                let (part, note) = lattice(records, row);
                parts.push(part);
                notes.extend(note);
            }
        }
    }
    parts.push(eddy(records));
    parts.push(control(records));
    verdict("GS-5", parts, notes)
}

/// The sweeps over one kind of data in one format.
fn sweeps<'a>(
    records: &'a Records,
    data: &'a str,
    format: &'a str,
    decimals: Option<u32>,
) -> impl Iterator<Item = &'a ToleranceRow> {
    let same = move |row: &&ToleranceRow| {
        row.data == data && row.format == format && row.decimals == decimals
    };
    records.own.tolerance.iter().filter(same)
}

/// The least ε, as a power of ten, down to which everything from 0.1 on is wrong: where false collinearities
/// begin. `None` if 0.1 is right.
pub(crate) fn limit_from_above(outcomes: &str) -> Option<i32> {
    let wrong = outcomes
        .chars()
        .take_while(|outcome| *outcome != 'r')
        .count();
    (wrong > 0).then_some(-(wrong as i32))
}

/// The largest ε, as a power of ten, up to which everything from the least on is wrong: where the method
/// begins to fail. `None` if the least is right, or if all are wrong.
pub(crate) fn limit_from_below(outcomes: &str) -> Option<i32> {
    let wrong = outcomes
        .chars()
        .rev()
        .take_while(|outcome| *outcome != 'r')
        .count();
    let all = outcomes.chars().count();
    (wrong > 0 && wrong < all).then(|| -((all - wrong + 1) as i32))
}

/// Of the sweeps, how many satisfy `is`, and how many there are.
fn share<'a>(
    rows: impl Iterator<Item = &'a ToleranceRow>,
    is: impl Fn(&str) -> bool,
) -> (usize, usize) {
    rows.fold((0, 0), |(hits, all), row| {
        (hits + usize::from(is(&row.outcomes)), all + 1)
    })
}

fn share_text((hits, all): (usize, usize)) -> String {
    let (low, high) = wilson::interval(hits, all);
    format!("{hits} of {all} [{low:.3}, {high:.3}]")
}

/// Whether the share is surely above `bound`, surely below, or neither.
fn above(share: (usize, usize), bound: f64) -> Outcome {
    let (low, high) = wilson::interval(share.0, share.1);
    match share.1 {
        0 => Outcome::NotTestable,
        _ if low > bound => Outcome::Confirmed,
        _ if high < bound => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    }
}

fn random(records: &Records, row: &Threshold) -> Part {
    let what = format!(
        "random, {}: false collinearities from 1e{} on (in the format {})",
        row.machine, row.exponent, row.format
    );
    let sweeps = sweeps(records, "random", &row.format, None);
    let share = share(sweeps, |outcomes| {
        limit_from_above(outcomes) == Some(row.exponent)
    });
    let statistic = format!(
        "that is the limit of {} random sets; at least {ORDINARY} asked for",
        share_text(share)
    );
    Part::new(what, above(share, ORDINARY), statistic)
}

/// How a lattice was presented: its name in the records, and the decimals kept.
type Presentation = (String, Option<u32>);

fn presentation_text((data, decimals): &Presentation) -> String {
    let place = if data == "lattice" {
        "turned about the origin"
    } else {
        "fitted into the unit square"
    };
    match decimals {
        None => format!("{place}, all digits"),
        Some(decimals) => format!("{place}, {decimals} decimals"),
    }
}

/// Every presentation of the lattice that was tried. First comes the one in the unit square, where the paper's
/// random data lie, with all digits.
fn presentations(records: &Records) -> Vec<Presentation> {
    let lattices = records
        .own
        .tolerance
        .iter()
        .filter(|row| row.data == "lattice" || row.data == "lattice-fitted");
    let mut found: Vec<Presentation> = lattices
        .map(|row| (row.data.clone(), row.decimals))
        .collect();
    found.sort_by_key(|(data, decimals)| (data != "lattice-fitted", *decimals));
    found.dedup();
    found
}

/// Whether most lattices fail at the printed power of ten and come right at the next.
fn lattice_outcome(
    records: &Records,
    row: &Threshold,
    presentation: &Presentation,
) -> (Outcome, String) {
    let right_at = |exponent: i32| {
        share(
            sweeps(records, &presentation.0, &row.format, presentation.1),
            |outcomes| {
                let place = usize::try_from(-exponent - 1).ok();
                place.and_then(|place| outcomes.chars().nth(place)) == Some('r')
            },
        )
    };
    let (here, next) = (right_at(row.exponent), right_at(row.exponent + 1));
    let wrong_here = (here.1 - here.0, here.1);
    let outcome = all_of([above(wrong_here, 0.5), above(next, 0.5)]);
    let text = format!(
        "{}: right at 1e{} {}, at 1e{} {}",
        presentation_text(presentation),
        row.exponent,
        share_text(here),
        row.exponent + 1,
        share_text(next)
    );
    (outcome, text)
}

/// The row for lattice data. The paper does not print the lattice's coordinates: if some presentations of it bear
/// the limit out and the first does not, the row cannot be tested without them.
fn lattice(records: &Records, row: &Threshold) -> (Part, Option<String>) {
    let what = format!(
        "lattice, {}: fails from 1e{} down (in the format {})",
        row.machine, row.exponent, row.format
    );
    let presentations = presentations(records);
    let Some(first) = presentations.first() else {
        return (Part::new(what, Outcome::NotTestable, "not run"), None);
    };
    let (outcome, statistic) = lattice_outcome(records, row, first);
    let fits: Vec<&Presentation> = presentations
        .iter()
        .filter(|presentation| lattice_outcome(records, row, presentation).0 == Outcome::Confirmed)
        .collect();
    let names = fits
        .iter()
        .map(|presentation| presentation_text(presentation))
        .collect::<Vec<_>>()
        .join("; ");
    let note = format!(
        "{}, lattice: of {} presentations of the lattice, {} bear the printed limit out{}{names}",
        row.machine,
        presentations.len(),
        fits.len(),
        if fits.is_empty() { "" } else { ": " }
    );
    let (outcome, statistic) = match (outcome, fits.first()) {
        (Outcome::Refuted, Some(fit)) => (
            Outcome::NotTestable,
            format!(
                "{statistic}; but {}: the paper prints no coordinates",
                lattice_outcome(records, row, fit).1
            ),
        ),
        _ => (outcome, statistic),
    };
    (Part::new(what, outcome, statistic), Some(note))
}

/// Eddy's method without a tolerance (the least one tried), on the formats of the paper's machines.
fn eddy(records: &Records) -> Part {
    let what = "Eddy's method does not give the lattice's hull, collinear points counted";
    let rows = records
        .own
        .tolerance
        .iter()
        .filter(|row| row.data == "lattice-eddy");
    let rows = rows.filter(|row| row.format == "ibm370" || row.format == "cdc7600");
    let wrong = share(rows, |outcomes| !outcomes.ends_with('r'));
    Part::new(
        what,
        above(wrong, 0.5),
        format!("wrong on {} turned lattices", share_text(wrong)),
    )
}

/// Exact answers need no tolerance: certified for the points as given, and the intended rings where the
/// lattice is exact.
fn control(records: &Records) -> Part {
    let what = "control: with exact answers nothing fails and no tolerance is needed";
    let rings: Vec<_> = records
        .own
        .rings
        .iter()
        .filter(|row| row.boundary == "all")
        .collect();
    let sets = records.own.tolerance.len();
    if rings.is_empty() || sets == 0 {
        return Part::new(what, Outcome::NotTestable, "not run");
    }
    let failures = records
        .failures
        .iter()
        .filter(|row| row.stage == "tolerance")
        .count();
    let right = rings
        .iter()
        .filter(|row| row.certified && row.rings == RINGS)
        .count();
    let outcome = if failures == 0 && right == rings.len() {
        Outcome::Confirmed
    } else {
        Outcome::Refuted
    };
    let statistic = format!(
        "{failures} of the turned lattices without a certificate; {right} of {} exact lattices with rings {RINGS}",
        rings.len()
    );
    Part::new(what, outcome, statistic)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::green_silverman::records::RingRow;

    #[test]
    fn limits_are_read_off_the_sweep() {
        assert_eq!(limit_from_above("wwwwrrrr"), Some(-4));
        assert_eq!(limit_from_above("rrrr"), None);
        assert_eq!(limit_from_below("wwrrrrrwcw"), Some(-8));
        assert_eq!(limit_from_below("wwrr"), None);
        assert_eq!(limit_from_below("wwww"), None);
    }

    /// Records in which every sweep of a kind has the same letters.
    fn records(random: [&str; 2], lattice: [&str; 2], rounded: &str, eddy: &str) -> Records {
        let mut records = Records::default();
        for replicate in 0..200 {
            let mut push = |data: &str, format: &str, decimals, outcomes: &str| {
                records.own.tolerance.push(ToleranceRow {
                    data: data.to_owned(),
                    format: format.to_owned(),
                    decimals,
                    replicate,
                    fingerprint: String::new(),
                    outcomes: outcomes.to_owned(),
                });
            };
            for (k, format) in ["ibm370", "cdc7600"].into_iter().enumerate() {
                push("random", format, None, random[k]);
                push("lattice-fitted", format, None, lattice[k]);
                push("lattice-fitted", format, Some(9), rounded);
                push("lattice-eddy", format, None, eddy);
            }
        }
        records.own.rings.push(RingRow {
            distribution: "lattice".into(),
            n: 100,
            boundary: "all".into(),
            method: "gs-peel".into(),
            rings: RINGS.into(),
            certified: true,
        });
        records
    }

    fn outcome(records: &Records) -> Outcome {
        judge(records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        let random = ["wwwwrrrrrrrr", "wwwwwrrrrrrr"];
        let as_printed = ["wwrrrrrwwwww", "wwrrrrrrrwww"];
        let never_fails = ["wwrrrrrwwwww", "wwrrrrrrrrrr"];
        let confirmed = records(random, as_printed, "wwrrrrrrrwww", "wwwwwwwwwwww");
        assert_eq!(outcome(&confirmed), Outcome::Confirmed);
        let with_digits = records(random, never_fails, "wwrrrrrrrwww", "wwwwwwwwwwww");
        assert_eq!(outcome(&with_digits), Outcome::NotTestable);
        let without = records(random, never_fails, "wwrrrrrrrrrr", "wwwwwwwwwwww");
        assert_eq!(outcome(&without), Outcome::Refuted);
        let other_random = records(["wrrrrrrrrrrr", random[1]], as_printed, "", "wwwwwwwwwwww");
        assert_eq!(outcome(&other_random), Outcome::Refuted);
        let mut uncertified = confirmed.clone();
        uncertified.own.rings[0].certified = false;
        assert_eq!(outcome(&uncertified), Outcome::Refuted);
        let mut few = confirmed;
        few.own.tolerance.retain(|row| row.replicate < 2);
        assert_eq!(outcome(&few), Outcome::NotDistinguishable);
    }
}
