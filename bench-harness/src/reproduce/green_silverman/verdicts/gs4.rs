//! GS-4: GS is faster than Eddy's method, the more so for small sets.

use super::{Outcome, Part, Verdict, all_of, ratio_text, with_time};
use crate::reproduce::green_silverman::derived::count_ratio;
use crate::reproduce::green_silverman::published::{DISTRIBUTIONS, Published, SIZES, cells};
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::ratio::time_ratio;
use crate::reproduce::rows::CountRow;
use crate::stats::bootstrap::Bootstrapped;
use crate::stats::holm;

const LEVEL: f64 = 0.05;

pub(super) fn judge(records: &Records, published: &Published) -> Verdict {
    let parts = vec![
        slower_in_time(records),
        falls_in_time(records),
        slower_in_counts(records),
        falls_in_counts(records),
    ];
    let outcome = with_time(
        all_of([parts[2].outcome, parts[3].outcome]),
        all_of([parts[0].outcome, parts[1].outcome]),
    );
    let mut notes = by_distribution(records, published);
    notes.extend(areas(records));
    if let Some(method) = hullkit::method("eddy") {
        notes.extend(
            method
                .departures
                .iter()
                .map(|departure| format!("our E departs from Eddy's: {departure}")),
        );
    }
    Verdict {
        id: "GS-4",
        outcome,
        parts,
        notes,
    }
}

fn slower_in_time(records: &Records) -> Part {
    let what = "time: E takes longer than GS in each of the six cells";
    let ratios: Option<Vec<Bootstrapped>> = cells()
        .map(|cell| time_ratio(&records.times, cell, "eddy", "gs"))
        .collect();
    let Some(ratios) = ratios else {
        return Part::new(what, Outcome::NotTestable, "not timed in every cell");
    };
    let p_values: Vec<f64> = ratios.iter().map(Bootstrapped::p_value).collect();
    let outcomes = ratios
        .iter()
        .zip(holm::adjusted(&p_values))
        .map(|(ratio, p)| match ratio.median {
            _ if p >= LEVEL => Outcome::NotDistinguishable,
            log if log > 0.0 => Outcome::Confirmed,
            _ => Outcome::Refuted,
        });
    let texts = cells().zip(&ratios).map(|((distribution, n), ratio)| {
        format!(
            "{distribution} {n} {}",
            ratio_text(ratio.median, ratio.interval(0.95))
        )
    });
    Part::new(
        what,
        all_of(outcomes),
        format!("E/GS {}", texts.collect::<Vec<_>>().join(", ")),
    )
}

/// By how much ln(E/GS) falls from n = 100 to n = 1,000 on `distribution`.
fn fall(records: &Records, distribution: &str) -> Option<Bootstrapped> {
    let [small, large] = SIZES;
    let at = |n| time_ratio(&records.times, (distribution, n), "eddy", "gs");
    Some(at(small)?.minus(&at(large)?))
}

fn falls_in_time(records: &Records) -> Part {
    let what = "time: E/GS is larger at n = 100 than at n = 1,000, mean of the three distributions";
    let falls: Option<Vec<Bootstrapped>> = DISTRIBUTIONS
        .iter()
        .map(|distribution| fall(records, distribution))
        .collect();
    let Some(mean) = falls.as_deref().and_then(Bootstrapped::mean_of) else {
        return Part::new(what, Outcome::NotTestable, "not timed in every cell");
    };
    let interval = mean.interval(0.95);
    Part::new(
        what,
        sign(interval),
        format!("falls by a factor {}", ratio_text(mean.median, interval)),
    )
}

fn slower_in_counts(records: &Records) -> Part {
    let what = "counts: E asks more questions than GS in each of the six cells";
    let ratios: Option<Vec<_>> = cells()
        .map(|cell| count_ratio(records, cell, "eddy", "gs", CountRow::questions))
        .collect();
    let Some(ratios) = ratios else {
        return Part::new(what, Outcome::NotTestable, "not counted in every cell");
    };
    let texts = cells()
        .zip(&ratios)
        .map(|((distribution, n), ratio)| format!("{distribution} {n} {:.3}", ratio.ratio()));
    let statistic = format!("E/GS {}", texts.collect::<Vec<_>>().join(", "));
    Part::new(
        what,
        all_of(ratios.iter().map(|ratio| sign(ratio.interval()))),
        statistic,
    )
}

fn falls_in_counts(records: &Records) -> Part {
    let what =
        "counts: E/GS is larger at n = 100 than at n = 1,000, mean of the three distributions";
    let [small, large] = SIZES;
    let falls: Option<Vec<(f64, f64)>> = DISTRIBUTIONS
        .iter()
        .map(|distribution| {
            let at = |n| {
                count_ratio(
                    records,
                    (distribution, n),
                    "eddy",
                    "gs",
                    CountRow::questions,
                )
            };
            let (small, large) = (at(small)?, at(large)?);
            Some((
                small.log - large.log,
                small.error.powi(2) + large.error.powi(2),
            ))
        })
        .collect();
    let Some(falls) = falls else {
        return Part::new(what, Outcome::NotTestable, "not counted in every cell");
    };
    let share = 1.0 / falls.len() as f64;
    let mean: f64 = falls.iter().map(|(log, _)| log * share).sum();
    let error = falls
        .iter()
        .map(|(_, variance)| variance)
        .sum::<f64>()
        .sqrt()
        * share;
    let interval = (mean - 3.0 * error, mean + 3.0 * error);
    Part::new(
        what,
        sign(interval),
        format!("falls by a factor {}", ratio_text(mean, interval)),
    )
}

fn sign(interval: (f64, f64)) -> Outcome {
    match interval {
        (low, _) if low > 0.0 => Outcome::Confirmed,
        (_, high) if high < 0.0 => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    }
}

/// E and GS in area evaluations alone: whether they ask about the same triangles.
fn areas(records: &Records) -> Option<String> {
    let ratio = |(distribution, n)| {
        let ratio = count_ratio(records, (distribution, n), "eddy", "gs", |row| {
            row.orientations
        })?;
        Some(format!("{distribution} {n} {:.4}", ratio.ratio()))
    };
    let ratios: Option<Vec<String>> = cells().map(ratio).collect();
    Some(format!(
        "E/GS in area evaluations alone: {}",
        ratios?.join(", ")
    ))
}

/// How E/GS changes with n on each distribution, beside the paper's own figures.
fn by_distribution(records: &Records, published: &Published) -> Vec<String> {
    let [small, large] = SIZES;
    let note = |distribution: &&str| {
        let ours = fall(records, distribution)?;
        let theirs = published.ratio_to_gs(distribution, small, "eddy")?
            / published.ratio_to_gs(distribution, large, "eddy")?;
        Some(format!(
            "{distribution}: E/GS at 100 over E/GS at 1,000 is {} in time (in the paper {theirs:.3})",
            ratio_text(ours.median, ours.interval(0.95))
        ))
    };
    DISTRIBUTIONS.iter().filter_map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn verdict(small: f64, large: f64, counts: f64) -> Outcome {
        let mut records = Records::default();
        let factor = |small: f64, large: f64| {
            move |method: &str, _: &str, n: usize| match (method, n) {
                ("eddy", 100) => small,
                ("eddy", _) => large,
                _ => 1.0,
            }
        };
        made_up::times(&mut records, &["gs", "eddy"], 0.02, factor(small, large));
        made_up::counts(&mut records, &["gs", "eddy"], factor(counts * 1.2, counts));
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(1.4, 1.2, 1.3), Outcome::Confirmed);
        assert_eq!(verdict(0.8, 0.9, 1.3), Outcome::CountsOnly);
        assert_eq!(verdict(1.2, 1.4, 0.5), Outcome::Refuted);
        assert_eq!(verdict(1.4, 1.4, 0.5), Outcome::NotDistinguishable);
    }
}
