//! B-1: what their divide and conquer costs.

use super::{Outcome, Verdict, all_of};
use crate::reproduce::balan::derived::runs;
use crate::reproduce::balan::records::{MergeRow, Records};
use crate::reproduce::balan::studies::merges::{LOOKING, SORTING};
use crate::reproduce::rows::CountRow;
use crate::reproduce::space::growth::{
    against_n, at_largest, does_not_rise, exponent, grows_as, questions,
};

/// Where the bound should hold.
const DISTRIBUTIONS: [&str; 5] = ["sphere", "ball", "normal3", "cone:axis=x", "fan:axis=x"];

/// Where V E should be reached.
const WORST: [&str; 2] = ["cone:axis=x", "fan:axis=x"];

/// A cost over its bound may rise with an exponent of this much before the bound is given up.
const MARGIN: f64 = 0.02;

pub(super) fn judge(records: &Records) -> Verdict {
    let bounded = DISTRIBUTIONS.map(|distribution| {
        let data = against_n(runs(records, distribution, SORTING), |row| {
            questions(row) / bound(row)
        });
        let what = format!("{distribution}: all questions are O(n log² n + V E log n)");
        does_not_rise(what, &data, MARGIN)
    });
    let reached = WORST.map(|distribution| {
        let data = top_merge(records, distribution, LOOKING);
        let what = format!(
            "{distribution}: the edges at hand in the steps of the top merge grow as V E, n²"
        );
        grows_as(what, &data, 2.0, 0.05)
    });
    let parts: Vec<_> = bounded.into_iter().chain(reached).collect();
    let outcome = all_of(parts.iter().map(|part| part.outcome));
    let mut notes = sharpness(records);
    notes.extend(random(records));
    if outcome != Outcome::NotTestable {
        notes.push(
            "the second logarithm is not needed: a merge of n points costs V E at most, and the halves, with V and E \
             half as large, cost a quarter of that each, so all levels together cost less than 2 V E"
                .to_owned(),
        );
    }
    Verdict {
        id: "B-1",
        outcome,
        parts,
        notes,
    }
}

/// V E with V vertices and 3 V - 6 edges.
fn vertices_by_edges(row: &CountRow) -> f64 {
    let vertices = row.vertices as f64;
    vertices * (3.0 * vertices - 6.0)
}

fn bound(row: &CountRow) -> f64 {
    let n = row.n as f64;
    n * n.log2().powi(2) + vertices_by_edges(row) * n.log2()
}

/// Comparisons of candidates in the top merge.
fn top_merge(records: &Records, distribution: &str, method: &str) -> Vec<(f64, f64)> {
    merges(records, distribution, method)
        .map(|row| (row.n as f64, row.top_candidates as f64))
        .collect()
}

fn merges<'a>(
    records: &'a Records,
    distribution: &'a str,
    method: &'a str,
) -> impl Iterator<Item = &'a MergeRow> {
    records
        .own
        .merges
        .iter()
        .filter(move |row| row.distribution == distribution && row.method == method)
}

/// What all merges cost beside the top one: log n times as much if every level costs V E.
fn sharpness(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let share: Vec<(f64, f64)> = merges(records, distribution, LOOKING)
            .map(|row| {
                let all = row.all_candidates as f64;
                (row.n as f64, all / row.top_candidates as f64)
            })
            .collect();
        let over_square = |method| {
            let (n, edges) = at_largest(&top_merge(records, distribution, method))?;
            Some(edges / (n * n))
        };
        let (n, share) = at_largest(&share)?;
        Some(format!(
            "{distribution}, n = {n}: {:.4} n² edges at hand in the top merge, {:.3} n² comparisons to sort them (with \
             buckets, as in the paper, the logarithm of the degree would go); all merges together cost {share:.2} times the \
             top one, not log₂ n = {:.1} times",
            over_square(LOOKING)?,
            over_square(SORTING)?,
            n.log2()
        ))
    };
    WORST.into_iter().filter_map(note).collect()
}

/// What the same work is on random points, where the worst case does not show.
fn random(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let of = |quantity: fn(&CountRow) -> f64| {
            exponent(&against_n(runs(records, distribution, SORTING), quantity))
        };
        let sorting = of(|row| row.candidates as f64)?;
        let shadows = of(|row| row.shadows as f64)?;
        Some(format!(
            "{distribution}: comparisons to sort edges grow with exponent {sorting}, those of Graham's scan (over points \
             that are sorted already, so without the paper's log n a merge) with {shadows}; n² is 2, n log n and n log² n \
             look like 1.1 and 1.2 there"
        ))
    };
    ["sphere", "ball", "normal3"]
        .into_iter()
        .filter_map(note)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn verdict(total: f64, top: f64) -> Outcome {
        let mut records = Records::default();
        made_up::counts(&mut records, &DISTRIBUTIONS, SORTING, |_, n| CountRow {
            vertices: n as usize / 2,
            orientations: n.powf(total) as u64,
            ..CountRow::default()
        });
        for n in made_up::SIZES {
            for (replicate, distribution) in [0, 1].into_iter().flat_map(|r| WORST.map(|w| (r, w)))
            {
                records.own.merges.push(MergeRow {
                    distribution: distribution.to_owned(),
                    n,
                    replicate,
                    method: LOOKING.to_owned(),
                    top_candidates: (n as f64).powf(top) as u64 + replicate,
                    all_candidates: 2 * n as u64,
                    ..MergeRow::default()
                });
            }
        }
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(1.2, 2.0), Outcome::Confirmed);
        assert_eq!(verdict(2.5, 2.0), Outcome::Refuted);
        assert_eq!(verdict(1.2, 1.5), Outcome::Refuted);
    }
}
