//! What we predicted before the run, beside what came out.

pub(crate) use super::n7::share_of_wrong_signs;
use super::{n1, n2, n3};
use crate::reproduce::nathan::published::Published;
use crate::reproduce::nathan::records::{LiftRow, Records};
use crate::reproduce::prediction::{self, Checked};

/// Every prediction, checked.
pub(crate) fn check<'a>(records: &Records, published: &'a Published) -> Vec<Checked<'a>> {
    prediction::check(&published.predictions, |id| measure(id, records))
}

/// The value of the prediction's measure.
fn measure(id: &str, records: &Records) -> Option<f64> {
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
    share_of_wrong_signs(records.lifting.iter().find(is_cell)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_prediction_has_a_measure() {
        let mut records = Records::default();
        for (n, offset) in [(10_000, 1e5), (10_000, 1e6), (10_000, 1e7), (1_000, 1e6)] {
            records.lifting.push(LiftRow {
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
        let published = Published::load().expect("valid");
        assert!(!published.predictions.is_empty());
        for checked in check(&records, &published) {
            assert!(checked.measured.is_some(), "{}", checked.prediction.id);
        }
    }
}
