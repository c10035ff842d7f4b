//! Records made up for the tests of the judges.

use crate::reproduce::nathan::records::{Records, WrapRow};

/// Wraps of `variant` in `order` of two distributions, with h = n / 2; each row is finished by `finish`.
pub(super) fn wraps(
    records: &mut Records,
    order: &str,
    variant: &str,
    finish: impl Fn(&mut WrapRow),
) {
    for distribution in ["ball", "sphere"] {
        for n in [64, 128, 256, 512, 1_024] {
            for replicate in 0..4 {
                let h = n / 2;
                let mut row = WrapRow {
                    distribution: distribution.to_owned(),
                    order: order.to_owned(),
                    n,
                    replicate,
                    variant: variant.to_owned(),
                    h,
                    triangles: 3 * h - 6,
                    searches: 3 * h as u64 - 6,
                    ..WrapRow::default()
                };
                finish(&mut row);
                records.own.wraps.push(row);
            }
        }
    }
}

/// n h times `factor`, give or take a hundredth from replicate to replicate.
pub(super) fn nh(row: &WrapRow, factor: f64) -> u64 {
    let wobble = 1.0 + 0.01 * (row.replicate as f64 - 1.5);
    (row.n as f64 * row.h as f64 * factor * wobble) as u64
}
