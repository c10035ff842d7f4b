//! GS-1: method GS is the fastest of the seven in every cell of Table 2.

use super::{Outcome, Part, Verdict, all_of, ratio_text, with_time};
use crate::reproduce::green_silverman::derived::TWIN;
use crate::reproduce::green_silverman::derived::count_ratio;
use crate::reproduce::green_silverman::published::{METHODS, Published, cells};
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::ratio::{time_ratio, timed_cells, timed_methods};
use crate::reproduce::rows::CountRow;
use crate::stats::holm;

/// The chance of any false "slower" or "faster" among all comparisons.
const LEVEL: f64 = 0.05;

/// How a rival compares with GS.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Comparison {
    Slower,
    Faster,
    Undecided,
}

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let time = by_time(records);
    let counts = by_counts(records);
    Verdict {
        id: "GS-1",
        outcome: with_time(counts.outcome, time.outcome),
        parts: vec![time, counts],
        notes: by_areas(records)
            .into_iter()
            .chain(beyond(records))
            .collect(),
    }
}

/// The other six methods in the paper's six cells.
fn comparisons() -> impl Iterator<Item = (&'static str, usize, &'static str)> {
    let rivals = METHODS.iter().skip(1);
    cells().flat_map(move |(distribution, n)| {
        rivals
            .clone()
            .map(move |(slug, _)| (distribution, n, *slug))
    })
}

fn by_time(records: &Records) -> Part {
    let what = "time: each of the other six takes longer in each of the six cells";
    let ratios: Option<Vec<_>> = comparisons()
        .map(|(distribution, n, rival)| time_ratio(&records.times, (distribution, n), rival, "gs"))
        .collect();
    let Some(ratios) = ratios else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not every method was timed in every cell",
        );
    };
    let p_values: Vec<f64> = ratios.iter().map(|ratio| ratio.p_value()).collect();
    let adjusted = holm::adjusted(&p_values);
    let compared: Vec<Comparison> = ratios
        .iter()
        .zip(&adjusted)
        .map(|(ratio, p)| match ratio.median {
            _ if *p >= LEVEL => Comparison::Undecided,
            log if log > 0.0 => Comparison::Slower,
            _ => Comparison::Faster,
        })
        .collect();
    let closest = comparisons()
        .zip(&ratios)
        .min_by(|a, b| a.1.median.total_cmp(&b.1.median));
    let closest = closest.map_or_else(String::new, |((distribution, n, rival), ratio)| {
        format!(
            "; closest: {rival} on {distribution} {n}, {} times GS",
            ratio_text(ratio.median, ratio.interval(0.95))
        )
    });
    Part::new(what, outcome(&compared), summary(&compared) + &closest)
}

fn by_counts(records: &Records) -> Part {
    let what = "counts: each of the other six asks more questions in each of the six cells";
    let ratios: Option<Vec<_>> = comparisons()
        .map(|(distribution, n, rival)| {
            count_ratio(records, (distribution, n), rival, "gs", CountRow::questions)
        })
        .collect();
    let Some(ratios) = ratios else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not every method was counted in every cell",
        );
    };
    let compared: Vec<Comparison> = ratios
        .iter()
        .map(|ratio| match ratio.interval() {
            (low, _) if low > 0.0 => Comparison::Slower,
            (_, high) if high < 0.0 => Comparison::Faster,
            _ => Comparison::Undecided,
        })
        .collect();
    let closest = comparisons()
        .zip(&ratios)
        .min_by(|a, b| a.1.log.total_cmp(&b.1.log));
    let closest = closest.map_or_else(String::new, |((distribution, n, rival), ratio)| {
        format!(
            "; closest: {rival} on {distribution} {n}, {:.3} times GS",
            ratio.ratio()
        )
    });
    Part::new(what, outcome(&compared), summary(&compared) + &closest)
}

fn outcome(compared: &[Comparison]) -> Outcome {
    all_of(compared.iter().map(|comparison| match comparison {
        Comparison::Slower => Outcome::Confirmed,
        Comparison::Faster => Outcome::Refuted,
        Comparison::Undecided => Outcome::NotDistinguishable,
    }))
}

fn summary(compared: &[Comparison]) -> String {
    let count = |kind| {
        compared
            .iter()
            .filter(|comparison| **comparison == kind)
            .count()
    };
    format!(
        "of {} comparisons GS wins {}, loses {}, {} undecided",
        compared.len(),
        count(Comparison::Slower),
        count(Comparison::Faster),
        count(Comparison::Undecided)
    )
}

/// The closest rival if only areas and angles are charged: the paper's program keeps the areas it evaluates, so
/// that comparing two distances costs it no arithmetic.
fn by_areas(records: &Records) -> Option<String> {
    let areas = |row: &CountRow| row.orientations + row.angles;
    let ratio = |(distribution, n, rival)| {
        Some((
            distribution,
            n,
            rival,
            count_ratio(records, (distribution, n), rival, "gs", areas)?,
        ))
    };
    let (distribution, n, rival, ratio) = comparisons()
        .filter_map(ratio)
        .min_by(|a, b| a.3.log.total_cmp(&b.3.log))?;
    Some(format!(
        "with only areas and angles charged, the closest is {rival} on {distribution} {n}, {:.3} times GS",
        ratio.ratio()
    ))
}

/// Every timed cell in which another method is faster than GS, methods and cells beyond the paper included;
/// and the noise of GS against itself.
fn beyond(records: &Records) -> Vec<String> {
    let mut notes = Vec::new();
    let mut widest = (0.0_f64, 0.0_f64);
    for (distribution, n) in timed_cells(&records.times) {
        let cell = (distribution.as_str(), n);
        if let Some(twin) = time_ratio(&records.times, cell, TWIN, "gs") {
            widest = (widest.0.min(twin.median), widest.1.max(twin.median));
        }
        for method in timed_methods(&records.times, cell)
            .iter()
            .filter(|method| *method != "gs" && *method != "gs-bare")
        {
            let Some(ratio) = time_ratio(&records.times, cell, method, "gs") else {
                continue;
            };
            let interval = ratio.interval(0.95);
            if interval.1 < 0.0 {
                notes.push(format!(
                    "{method} is faster than GS on {distribution} {n}: {} times GS",
                    ratio_text(ratio.median, interval)
                ));
            }
        }
    }
    if !records.times.is_empty() {
        notes.push(format!(
            "GS against itself, median ratio by cell: from {:.3} to {:.3}",
            widest.0.exp(),
            widest.1.exp()
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    const SLUGS: [&str; 7] = [
        "gs",
        "eddy",
        "graham",
        "jarvis-j1",
        "jarvis-j2",
        "jarvis-j3",
        "incremental-r",
    ];

    fn verdict(
        times: impl Fn(&str, &str, usize) -> f64,
        counts: impl Fn(&str, &str, usize) -> f64,
    ) -> Outcome {
        let mut records = Records::default();
        made_up::times(&mut records, &SLUGS, 0.05, times);
        made_up::counts(&mut records, &SLUGS, counts);
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        let gs_least = |method: &str, _: &str, _: usize| if method == "gs" { 1.0 } else { 2.0 };
        let graham_less = |method: &str, _: &str, n: usize| match method {
            "gs" => 1.0,
            "graham" if n == 1_000 => 0.5,
            _ => 2.0,
        };
        let all_same = |_: &str, _: &str, _: usize| 1.0;
        assert_eq!(verdict(gs_least, gs_least), Outcome::Confirmed);
        assert_eq!(verdict(graham_less, gs_least), Outcome::CountsOnly);
        assert_eq!(verdict(graham_less, graham_less), Outcome::Refuted);
        assert_eq!(verdict(all_same, all_same), Outcome::NotDistinguishable);
    }
}
