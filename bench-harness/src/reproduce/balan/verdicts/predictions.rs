//! What we predicted before the run, beside what came out.

use super::{b3, b4, b6};
use crate::reproduce::balan::records::Records;

/// The value of what the prediction called `id` is about.
pub(crate) fn measure(id: &str, records: &Records) -> Option<f64> {
    match id {
        "ball-tests" => b3::over_power(records, "ball", 1.5),
        "ball-expectation" => b3::over_expectation(records, "ball"),
        "normal-expectation" => b3::over_expectation(records, "normal3"),
        "cauchy-tests" => b3::over_power(records, "cauchy3", 1.0),
        "sphere-facets" => Some(b4::facets_a_point(records, "sphere")?.1),
        "sphere-conflicts" => Some(b4::sphere_line(records)?.slope),
        "quickhull-ball" => b6::of_twin(records, "ball"),
        "quickhull-cube" => b6::of_twin(records, "cube"),
        "quickhull-normal" => b6::of_twin(records, "normal3"),
        "quickhull-cauchy" => b6::of_twin(records, "cauchy3"),
        "quickhull-sphere" => Some(b6::sphere_line(records)?.slope),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::balan::Balan;
    use crate::reproduce::paper::checks;
    use crate::reproduce::rows::CountRow;

    #[test]
    fn every_prediction_has_a_measure() {
        let mut records = Records::default();
        let distributions = ["sphere", "ball", "cube", "normal3", "cauchy3"];
        for method in ["incremental-3d", "incremental-conflict", "quickhull-3d"] {
            made_up::counts(&mut records, &distributions, method, |_, n| CountRow {
                orientations: (9.0 * n.powf(1.5)) as u64,
                facets: n as u64,
                ..CountRow::default()
            });
        }
        let checked = checks::predictions::<Balan>(&records);
        assert!(checked.len() >= 10);
        assert!(checked.values().all(Option::is_some), "{checked:?}");
    }
}
