//! D-6: where to stop the recursion.

use super::{Outcome, Part, Verdict, share, verdict};
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::{BaseRow, Records};
use crate::stats::summary::{deviation, mean};
use crate::stats::wilson;
use std::collections::BTreeMap;

/// The paper's own choice.
const TETRAHEDRON: &str = "tetrahedron";

/// No base at all.
const SINGLE: &str = "none";

pub(super) fn judge(records: &Records) -> Verdict {
    let names = in_order(records.own.bases.iter().map(|row| &row.distribution));
    let mut parts: Vec<Part> = names.iter().map(|name| fewer(records, name)).collect();
    parts.push(dummies(records));
    let notes = names.iter().flat_map(|name| notes(records, name)).collect();
    verdict("D-6", parts, notes)
}

/// Orientations a point of each base on `distribution`, by size and way: one value a set.
fn bases<'a>(records: &'a Records, distribution: &str) -> BTreeMap<(usize, &'a str), Vec<f64>> {
    let mut bases: BTreeMap<(usize, &str), Vec<f64>> = BTreeMap::new();
    for row in &records.own.bases {
        if row.distribution == distribution {
            let values = bases.entry((row.size, row.way.as_str())).or_default();
            values.push(BaseRow::total(row) as f64 / row.n as f64);
        }
    }
    bases
}

/// Whether tetrahedra take fewer orientations than single points, set by set.
fn fewer(records: &Records, distribution: &str) -> Part {
    let what =
        format!("{distribution}: fewer orientations with tetrahedra than from single points on");
    let bases = bases(records, distribution);
    let both = (bases.get(&(1, SINGLE)), bases.get(&(4, TETRAHEDRON)));
    let (Some(single), Some(tetrahedra)) = both else {
        return Part::new(what, Outcome::NotTestable, "not counted");
    };
    let pairs = single.iter().zip(tetrahedra);
    let savings: Vec<f64> = pairs
        .map(|(single, tetrahedra)| single - tetrahedra)
        .collect();
    let half = 1.96 * deviation(&savings) / (savings.len() as f64).sqrt();
    let saving = mean(&savings);
    let outcome = if saving - half > 0.0 {
        Outcome::Confirmed
    } else if saving + half < 0.0 {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    let statistic = format!(
        "{:.3} a point from single points on; {saving:.3} ± {half:.3} fewer with tetrahedra",
        mean(single)
    );
    Part::new(what, outcome, statistic)
}

/// Whether sets that need dummy points come out right as consistently as the paper says of all.
fn dummies(records: &Records) -> Part {
    let what = "dummy points inside do no harm: n no multiple of four, extended, eps2 = 1e16";
    let sets: usize = records.own.dummies.iter().map(|row| row.sets).sum();
    let right: usize = records.own.dummies.iter().map(|row| row.right).sum();
    let (low, high) = wilson::interval(right, sets);
    let outcome = match sets {
        0 => Outcome::NotTestable,
        _ if low > 0.95 => Outcome::Confirmed,
        _ if high < 0.95 => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    };
    Part::new(what, outcome, share(right, sets))
}

/// All bases, and the best.
fn notes(records: &Records, distribution: &str) -> Vec<String> {
    let bases = bases(records, distribution);
    let name = |(size, way): &(usize, &str)| match *way {
        SINGLE => "single points".to_owned(),
        TETRAHEDRON => "tetrahedra".to_owned(),
        way => format!("{size} points by {way}"),
    };
    let text: Vec<String> = bases
        .iter()
        .map(|(base, values)| format!("{} {:.2}", name(base), mean(values)))
        .collect();
    let best = bases
        .iter()
        .min_by(|(_, x), (_, y)| mean(x).total_cmp(&mean(y)));
    let best = best.map_or_else(String::new, |(base, _)| {
        format!("; the fewest with {}", name(base))
    });
    vec![format!(
        "{distribution}: orientations a point, parts and merges above them: {}{best}",
        text.join(", ")
    )]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::day::records::DummyRow;

    fn judged(tetrahedra: u64, spread: u64, right: usize) -> Outcome {
        let mut records = Records::default();
        for replicate in 0..5 {
            let row = |size, way: &str, base| BaseRow {
                distribution: "ball".to_owned(),
                n: 64,
                replicate,
                size,
                way: way.to_owned(),
                base,
                merges: 1_000,
            };
            let off = spread * (replicate % 2);
            records.own.bases.extend([
                row(1, SINGLE, 300),
                row(4, TETRAHEDRON, tetrahedra + off),
                row(8, "every triple", 900),
            ]);
        }
        records.own.dummies.push(DummyRow {
            sets: 100,
            right,
            ..DummyRow::default()
        });
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(16, 3, 100), Outcome::Confirmed);
        assert_eq!(judged(400, 3, 100), Outcome::Refuted);
        assert_eq!(judged(250, 100, 100), Outcome::NotDistinguishable);
        assert_eq!(judged(16, 3, 80), Outcome::Refuted);
        assert_eq!(judged(16, 3, 96), Outcome::NotDistinguishable);
    }
}
