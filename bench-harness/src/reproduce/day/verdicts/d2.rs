//! D-2: whether the longer format is the slower one.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::day::definition::Arithmetic;
use crate::reproduce::day::derived::speed_ratio;
use crate::reproduce::day::records::Records;
use crate::reproduce::verdict::ratio_text;

pub(super) fn judge(records: &Records) -> Verdict {
    let parts = vec![
        faster(records, "extended", "f32"),
        faster(records, "extended", "f64"),
    ];
    verdict("D-2", parts, notes(records))
}

/// Whether `format` is faster than `base`, if the processor computes in both.
fn faster(records: &Records, format: &str, base: &str) -> Part {
    let what = format!("{format} is faster than {base}");
    let in_software = |name: &str| {
        let mut rows = records.own.speed.iter().filter(|row| row.format == name);
        rows.any(|row| row.arithmetic == Arithmetic::Software)
    };
    let ratio = speed_ratio(records, format, base);
    let text = ratio
        .as_ref()
        .map(|ratio| ratio_text(ratio.median, ratio.interval(0.95)));
    if in_software(format) || in_software(base) {
        let statistic = format!(
            "{format} is computed by a program here, so that its time says nothing of a machine that has it; time ratio {}",
            text.unwrap_or_default()
        );
        return Part::new(what, Outcome::NotTestable, statistic);
    }
    let Some(ratio) = ratio else {
        return Part::new(what, Outcome::NotTestable, "not timed");
    };
    let (low, high) = ratio.interval(0.95);
    let outcome = if high < 0.0 {
        Outcome::Confirmed
    } else if low > 0.0 {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    Part::new(
        what,
        outcome,
        format!("time ratio {}", text.unwrap_or_default()),
    )
}

/// What can be compared: the two formats that the processor has, and what it costs to do without.
fn notes(records: &Records) -> Vec<String> {
    let pairs = [("f64", "f32"), ("cdc7600", "f64"), ("ibm370", "f32")];
    let note = |(format, base): (&str, &str)| {
        let ratio = speed_ratio(records, format, base)?;
        let text = ratio_text(ratio.median, ratio.interval(0.95));
        Some(format!("time of {format} over that of {base}: {text}"))
    };
    pairs.into_iter().filter_map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::day::records::SpeedRow;

    fn judged(arithmetic: Arithmetic, extended: u64) -> Outcome {
        let mut records = Records::default();
        for (format, time) in [("f32", 1_000), ("f64", 1_100), ("extended", extended)] {
            for (realisation, round) in (0..5).flat_map(|i| (0..4).map(move |j| (i, j))) {
                records.own.speed.push(SpeedRow {
                    format: format.to_owned(),
                    arithmetic: match format {
                        "extended" => arithmetic,
                        _ => Arithmetic::Hardware,
                    },
                    n: 100,
                    realisation,
                    round,
                    calls: 1,
                    nanoseconds: time + 7 * u64::from(round) + realisation,
                });
            }
        }
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(Arithmetic::Hardware, 900), Outcome::Confirmed);
        assert_eq!(judged(Arithmetic::Hardware, 2_000), Outcome::Refuted);
        assert_eq!(judged(Arithmetic::Software, 900), Outcome::NotTestable);
    }
}
