//! What tables, figures and verdicts compute from the records, cell by cell.

use super::records::{MergeRow, PrecisionRow, Records, SpeedRow};
use super::studies::METHOD;
use crate::reproduce::rows::TimeRow;
use crate::reproduce::space::growth::at_largest;
use crate::stats::bootstrap::{Bootstrapped, clustered_median};
use crate::stats::line::{Line, fit};
use crate::stats::logistic::{self, Logistic};
use std::collections::{BTreeMap, BTreeSet};

/// The paper's eps2, as a power of ten.
pub(crate) const DAYS_POWER: i32 = 16;

/// The formats of the paper, from the shortest.
pub(crate) const FORMATS: [&str; 3] = ["f32", "f64", "extended"];

/// FAN with the wrap beginning away from the vertex that recurs; FAN; CONE.
pub(crate) const WORST: [&str; 3] = ["turned fan:axis=x", "fan:axis=x", "cone:axis=x"];

/// One format in one range at one offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setting<'a> {
    pub(crate) n: usize,
    pub(crate) range: f64,
    pub(crate) offset: f64,
    pub(crate) format: &'a str,
    pub(crate) bits: u32,
}

impl<'a> Setting<'a> {
    fn of(row: &'a PrecisionRow) -> Self {
        Self {
            n: row.n,
            range: row.range,
            offset: row.offset,
            format: &row.format,
            bits: row.bits,
        }
    }

    /// Whether this is the distribution as drawn, in the unit cube.
    pub(crate) fn is_plain(&self) -> bool {
        self.range == 1.0 && self.offset == 0.0
    }
}

/// The settings of the study, in the order of the records.
pub(crate) fn settings(records: &Records) -> Vec<Setting<'_>> {
    let mut settings = Vec::new();
    for row in &records.own.precision {
        let setting = Setting::of(row);
        if !settings.contains(&setting) {
            settings.push(setting);
        }
    }
    settings
}

/// The rows of a setting, by power.
pub(crate) fn powers<'a>(records: &'a Records, setting: Setting<'a>) -> Vec<&'a PrecisionRow> {
    let rows = records.own.precision.iter();
    let mut rows: Vec<_> = rows.filter(|row| Setting::of(row) == setting).collect();
    rows.sort_by_key(|row| row.power);
    rows
}

/// Right of tried in the rows, together.
pub(crate) fn right_of<'a>(rows: impl Iterator<Item = &'a PrecisionRow>) -> (usize, usize) {
    rows.fold((0, 0), |(right, sets), row| {
        (right + row.right, sets + row.sets)
    })
}

/// The largest good eps2 of a setting: where the share right has fallen to a half, in powers of ten.
///
/// Of small eps2 too few are right for another reason, so the fall is looked for from the power with the largest share
/// on. `None` if no more than half are ever right, or if they never fall.
pub(crate) fn threshold(records: &Records, setting: Setting<'_>) -> Option<Logistic> {
    let rows = powers(records, setting);
    let share = |row: &PrecisionRow| row.right as f64 / row.sets.max(1) as f64;
    let best = rows.iter().map(|row| share(row)).fold(0.0, f64::max);
    let from = rows.iter().rposition(|row| share(row) >= best)?;
    if best <= 0.5 || share(rows.last()?) >= 0.5 {
        return None;
    }
    let falling = rows[from..].iter();
    let data: Vec<_> = falling
        .map(|row| (f64::from(row.power), row.right, row.sets))
        .collect();
    logistic::fit(&data).filter(|curve| curve.slope < 0.0)
}

/// The thresholds of all formats in the unit cube at size `n`: bits, threshold, its error.
pub(crate) fn thresholds(records: &Records, n: usize) -> Vec<(f64, f64, f64)> {
    let plain = settings(records)
        .into_iter()
        .filter(|setting| setting.is_plain() && setting.n == n);
    let known = plain.filter_map(|setting| {
        let curve = threshold(records, setting)?;
        Some((f64::from(setting.bits), curve.half, curve.half_error))
    });
    known.collect()
}

/// The line of the thresholds against the bits, at the largest n with three formats or more, and that n.
pub(crate) fn line_of_bits(records: &Records) -> Option<(usize, Line)> {
    let sizes: BTreeSet<usize> = records.own.precision.iter().map(|row| row.n).collect();
    let full = |n: &usize| {
        let found = thresholds(records, *n);
        let data: Vec<_> = found
            .iter()
            .map(|&(bits, half, _)| (bits, half, 1.0))
            .collect();
        Some((*n, fit(&data)?))
    };
    sizes.iter().rev().find_map(full)
}

/// The merges on `distribution` by the rule `variant`.
pub(crate) fn merges<'a>(
    records: &'a Records,
    distribution: &'a str,
    variant: &'a str,
) -> impl Iterator<Item = &'a MergeRow> {
    let rows = records.own.merges.iter();
    rows.filter(move |row| row.distribution == distribution && row.variant == variant)
}

/// n and `quantity` of each of these.
pub(crate) fn of_merges(
    records: &Records,
    distribution: &str,
    variant: &str,
    quantity: impl Fn(&MergeRow) -> f64,
) -> Vec<(f64, f64)> {
    let rows = merges(records, distribution, variant);
    rows.map(|row| (row.n as f64, quantity(row))).collect()
}

/// Questions at the top merge against n.
pub(crate) fn top(records: &Records, distribution: &str, variant: &str) -> Vec<(f64, f64)> {
    of_merges(records, distribution, variant, |row| {
        row.top_candidates as f64
    })
}

/// n, and the mean of `quantity`, at the largest n.
pub(crate) fn largest(
    records: &Records,
    distribution: &str,
    variant: &str,
    quantity: impl Fn(&MergeRow) -> f64,
) -> Option<(f64, f64)> {
    at_largest(&of_merges(records, distribution, variant, quantity))
}

/// The distributions merged by the rule `variant`, each once, in the order of the alphabet.
pub(crate) fn merged<'a>(records: &'a Records, variant: &'a str) -> Vec<&'a str> {
    let rows = records
        .own
        .merges
        .iter()
        .filter(|row| row.variant == variant);
    let names: BTreeSet<&str> = rows.map(|row| row.distribution.as_str()).collect();
    names.into_iter().collect()
}

/// The distributions of `rows`, each once, in the order of the records.
pub(crate) fn in_order<'a>(names: impl Iterator<Item = &'a String>) -> Vec<&'a str> {
    let mut found: Vec<&str> = Vec::new();
    for name in names {
        if !found.contains(&name.as_str()) {
            found.push(name);
        }
    }
    found
}

/// n and the nanoseconds of each sample of the whole call, by one processor.
pub(crate) fn times(records: &Records, distribution: &str) -> Vec<(f64, f64)> {
    let mut rounds: BTreeMap<(usize, u64), Vec<f64>> = BTreeMap::new();
    let rows = records.times.iter();
    for row in rows.filter(|row| row.distribution == distribution && row.method == METHOD) {
        let samples = rounds.entry((row.n, row.realisation)).or_default();
        samples.push(TimeRow::per_call(row));
    }
    let median = |((n, _), samples): ((usize, u64), Vec<f64>)| {
        (n as f64, crate::stats::summary::median(&samples))
    };
    rounds.into_iter().map(median).collect()
}

/// The logarithm of the time of one format over that of another on the same sets.
pub(crate) fn speed_ratio(records: &Records, format: &str, base: &str) -> Option<Bootstrapped> {
    let of = |name: &str| -> BTreeMap<(u64, u32), f64> {
        let rows = records.own.speed.iter().filter(|row| row.format == name);
        let time = |row: &SpeedRow| row.nanoseconds as f64 / row.calls as f64;
        rows.map(|row| ((row.realisation, row.round), time(row)))
            .collect()
    };
    let below = of(base);
    let mut clusters: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
    for (key, time) in of(format) {
        if let Some(base) = below.get(&key) {
            clusters.entry(key.0).or_default().push((time / base).ln());
        }
    }
    clustered_median(&clusters.into_values().collect::<Vec<_>>(), 1)
}
