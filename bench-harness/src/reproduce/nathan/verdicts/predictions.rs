//! What we predicted before the run, beside what came out.

pub(crate) use super::n7::share_of_wrong_signs;
use super::{n1, n2, n3};
use crate::reproduce::nathan::records::{LiftRow, Records};

/// The value of what the prediction called `id` is about.
pub(crate) fn measure(id: &str, records: &Records) -> Option<f64> {
    match id {
        "slope-sphere" => n1::slope(records, "sphere"),
        "slope-ball" => n1::slope(records, "ball"),
        "constant" => n1::constant(records),
        "pivoting" => n1::pivot_share(records),
        "three-h" => n2::share_of_3h(records),
        "array" => n3::share_of_square(records),
        "signs-1e5" => wrong_signs(records, 10_000, 1e5),
        "signs-1e6" => wrong_signs(records, 10_000, 1e6),
        "signs-1e7" => wrong_signs(records, 10_000, 1e7),
        "signs-1e6-small" => wrong_signs(records, 1_000, 1e6),
        _ => None,
    }
}

/// The share of wrong signs of `n` points of the square at `offset`.
fn wrong_signs(records: &Records, n: usize, offset: f64) -> Option<f64> {
    let is_cell = |row: &&LiftRow| {
        row.distribution == "square" && row.n == n && row.offset.total_cmp(&offset).is_eq()
    };
    share_of_wrong_signs(records.own.lifting.iter().find(is_cell)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::nathan::Nathan;
    use crate::reproduce::paper::checks;

    #[test]
    fn every_prediction_has_a_measure() {
        let mut records = Records::default();
        for (n, offset) in [(10_000, 1e5), (10_000, 1e6), (10_000, 1e7), (1_000, 1e6)] {
            records.own.lifting.push(LiftRow {
                distribution: "square".to_owned(),
                n,
                offset,
                quadruples: 100,
                wrong_signs: 30,
                ..LiftRow::default()
            });
        }
        for (variant, triangles) in [("printed", 3), ("pivot-wrap", 2)] {
            super::super::made_up::wraps(&mut records, "random", variant, |row| {
                row.triangles = triangles * row.h - 2 * triangles;
                row.repetitions = row.h - 2;
                row.plane_tests = 7;
                row.mark_comparisons = 7;
            });
        }
        let checked = checks::predictions::<Nathan>(&records);
        assert!(checked.values().all(Option::is_some), "{checked:?}");
    }
}
