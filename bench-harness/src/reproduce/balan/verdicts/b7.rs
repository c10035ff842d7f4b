//! B-7: which program is faster.

use super::{Outcome, Part, Verdict};
use crate::reproduce::balan::derived::{BASE, TWIN};
use crate::reproduce::balan::published::PROGRAMS;
use crate::reproduce::balan::records::Records;
use crate::reproduce::ratio::{time_ratio, timed_cells, timed_methods};
use crate::reproduce::verdict::ratio_text;

pub(super) fn judge(records: &Records) -> Verdict {
    let part = Part::new(
        "a comparison of the three programs in practice",
        Outcome::NotTestable,
        "the paper prints no times; its divide and conquer was in Java and the other two in Python, so its own times \
         would have compared languages too",
    );
    Verdict {
        id: "B-7",
        outcome: part.outcome,
        parts: vec![part],
        notes: fastest(records).into_iter().chain(noise(records)).collect(),
    }
}

/// In each timed cell, the other two of the paper's programs beside the fastest.
fn fastest(records: &Records) -> Vec<String> {
    let mut notes = Vec::new();
    for (distribution, n) in timed_cells(&records.times) {
        let cell = (distribution.as_str(), n);
        let timed = timed_methods(&records.times, cell);
        let programs = PROGRAMS.map(|(slug, _)| slug);
        if !programs.iter().all(|slug| timed.iter().any(|t| t == slug)) {
            continue;
        }
        let to_base =
            |slug: &&str| time_ratio(&records.times, cell, slug, BASE).map(|ratio| ratio.median);
        let Some(first) = programs.into_iter().min_by(|a, b| {
            let time = |slug| to_base(slug).unwrap_or(f64::INFINITY);
            time(a).total_cmp(&time(b))
        }) else {
            continue;
        };
        let others = programs.into_iter().filter(|slug| *slug != first);
        let ratios: Vec<String> = others
            .filter_map(|slug| {
                let ratio = time_ratio(&records.times, cell, slug, first)?;
                let text = ratio_text(ratio.median, ratio.interval(0.95));
                Some(format!("{slug} {text}"))
            })
            .collect();
        notes.push(format!(
            "{distribution} {n}, all three in one language: {first} is the fastest; times it: {}",
            ratios.join(", ")
        ));
    }
    notes
}

/// The base against itself.
fn noise(records: &Records) -> Option<String> {
    let medians: Vec<f64> = timed_cells(&records.times)
        .iter()
        .filter_map(|(distribution, n)| time_ratio(&records.times, (distribution, *n), TWIN, BASE))
        .map(|ratio| ratio.median.exp())
        .collect();
    let least = medians.iter().copied().fold(f64::INFINITY, f64::min);
    let most = medians.iter().copied().fold(0.0, f64::max);
    (!medians.is_empty()).then(|| {
        format!("{BASE} against itself, median ratio by cell: from {least:.3} to {most:.3}")
    })
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn times_do_not_make_it_testable_but_are_told() {
        let mut records = Records::default();
        let slugs = [
            "preparata-hong-balan",
            "incremental-3d",
            "quickhull-balan",
            BASE,
        ];
        made_up::times(&mut records, &slugs, |method| match method {
            "quickhull-balan" => 2.0,
            BASE => 1.0,
            _ => 5.0,
        });
        let verdict = judge(&records);
        assert_eq!(verdict.outcome, Outcome::NotTestable);
        assert!(verdict.notes[0].contains("quickhull-balan is the fastest"));
    }
}
