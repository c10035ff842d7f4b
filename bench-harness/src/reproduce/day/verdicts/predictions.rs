//! What we predicted before the run, beside what came out.

use super::d3::questions_a_facet;
use crate::reproduce::day::derived::{WORST, largest, line_of_bits};
use crate::reproduce::day::records::Records;

/// The value of what the prediction called `id` is about.
pub(crate) fn measure(id: &str, records: &Records) -> Option<f64> {
    let [turned_fan, _, cone] = WORST;
    let over_power = |distribution, variant, power| {
        let (n, asked) = largest(records, distribution, variant, |row| {
            row.top_candidates as f64
        })?;
        Some(asked / n.powi(power))
    };
    let a_facet =
        |distribution| Some(largest(records, distribution, "resumed", questions_a_facet)?.1);
    match id {
        "fan-resumed" => over_power(turned_fan, "resumed", 1),
        "cone-resumed" => over_power(cone, "resumed", 1),
        "fan-rescan" => over_power(turned_fan, "rescanned", 2),
        "cone-rescan" => over_power(cone, "rescanned", 2),
        "sphere-a-facet" => a_facet("sphere"),
        "ball-a-facet" => a_facet("ball"),
        "sphere-rescan" => rescanned_over_resumed(records, "sphere"),
        "bits" => Some(line_of_bits(records)?.1.slope),
        _ => None,
    }
}

/// Questions at the top merge with every search anew over those of the resumed search, at the largest n of both.
fn rescanned_over_resumed(records: &Records, distribution: &str) -> Option<f64> {
    let (n, anew) = largest(records, distribution, "rescanned", |row| {
        row.top_candidates as f64
    })?;
    let same_n: Vec<f64> = records
        .own
        .merges
        .iter()
        .filter(|row| row.distribution == distribution && row.variant == "resumed")
        .filter(|row| row.n as f64 == n)
        .map(|row| row.top_candidates as f64)
        .collect();
    (!same_n.is_empty()).then(|| anew / crate::stats::summary::mean(&same_n))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::day::Day;
    use crate::reproduce::day::records::MergeRow;
    use crate::reproduce::paper::checks;

    #[test]
    fn every_prediction_has_a_measure() {
        let mut records = Records::default();
        let names = ["sphere", "ball", WORST[0], WORST[2]];
        for variant in ["resumed", "rescanned"] {
            made_up::merges(&mut records, &names, variant, |n| MergeRow {
                top_candidates: (5.0 * n) as u64,
                top_facets: n as u64,
                ..MergeRow::default()
            });
        }
        made_up::precision(&mut records, [6.5, 13.5, 18.5], 100);
        let checked = checks::predictions::<Day>(&records);
        assert!(checked.values().all(Option::is_some), "{checked:?}");
        assert_eq!(checked["fan-resumed"], Some(true));
        assert_eq!(checked["cone-resumed"], Some(false));
    }
}
