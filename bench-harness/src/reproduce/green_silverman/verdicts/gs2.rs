//! GS-2: the printed average numbers of vertices are those of the stated distributions.

use super::{Outcome, Part, Verdict, all_of};
use crate::reproduce::green_silverman::derived::sizes;
use crate::reproduce::green_silverman::published::{Published, cells};
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::theory::hull_size::expected;
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Our own averages may be this many standard errors off: for six cells together as rare as three for one.
const OURS: f64 = 3.5;

pub(super) fn judge(records: &Records, published: &Published) -> Verdict {
    let ours = ours(records);
    // A generator that misses the expectation says nothing about the paper.
    let theirs = match ours.outcome {
        Outcome::Confirmed => theirs(records, published),
        _ => Part::new(
            THEIRS,
            Outcome::NotTestable,
            "our own averages do not agree with the expectation",
        ),
    };
    let outcome = match ours.outcome {
        Outcome::Refuted => Outcome::NotTestable,
        _ => all_of([ours.outcome, theirs.outcome]),
    };
    Verdict {
        id: "GS-2",
        outcome,
        parts: vec![ours, theirs],
        notes: flagged(records, published),
    }
}

const THEIRS: &str = "the six printed averages agree with the exact expectations";

fn ours(records: &Records) -> Part {
    let what = "our averages agree with the exact expectations (the generators are right)";
    let scores: Option<Vec<f64>> = cells()
        .map(|cell| Some(sizes(records, cell)?.z(expected(cell.0, cell.1)?)))
        .collect();
    let Some(scores) = scores else {
        return Part::new(what, Outcome::NotTestable, "not every cell was measured");
    };
    let worst = scores.iter().fold(0.0_f64, |worst, z| worst.max(z.abs()));
    let outcome = if worst < OURS {
        Outcome::Confirmed
    } else {
        Outcome::Refuted
    };
    Part::new(
        what,
        outcome,
        format!("largest |z| of six cells {worst:.2}, at most {OURS} allowed"),
    )
}

/// z of a printed average: our spread, the paper's number of realisations.
fn score(records: &Records, published: &Published, cell: (&str, usize)) -> Option<f64> {
    let printed = published.table2(cell.0, cell.1, "average vertices")?;
    let realisations = published.table2(cell.0, cell.1, "realisations")?;
    Some((printed - expected(cell.0, cell.1)?) / sizes(records, cell)?.error(realisations))
}

fn theirs(records: &Records, published: &Published) -> Part {
    let scores: Option<Vec<f64>> = cells()
        .map(|cell| score(records, published, cell))
        .collect();
    let Some(scores) = scores else {
        return Part::new(THEIRS, Outcome::NotTestable, "not every cell was measured");
    };
    let statistic: f64 = scores.iter().map(|z| z * z).sum();
    let freedom = scores.len() as f64;
    let p = ChiSquared::new(freedom).map_or(f64::NAN, |chi| chi.sf(statistic));
    let outcome = match p {
        p if p >= 0.05 => Outcome::Confirmed,
        p if p < 0.01 => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    };
    Part::new(
        THEIRS,
        outcome,
        format!("chi-squared {statistic:.2} on {freedom} degrees of freedom, p = {p:.3}"),
    )
}

/// The cells whose printed average is more than 1.96 standard errors off.
fn flagged(records: &Records, published: &Published) -> Vec<String> {
    let score = |cell: (&'static str, usize)| Some((cell, score(records, published, cell)?));
    cells()
        .filter_map(score)
        .filter(|(_, z)| z.abs() > 1.96)
        .map(|((distribution, n), z)| {
            format!("the printed average of {distribution} {n} is off: z = {z:.2}")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::rows::SizeRow;

    /// Two kinds of hulls, `spread` below and above the expectation plus `shift`.
    fn records(spread: f64, shift: f64) -> Records {
        let mut records = Records::default();
        for (distribution, n) in cells() {
            let center = expected(distribution, n).expect("a formula") + shift;
            for vertices in [center - spread, center + spread] {
                // Whole vertices only: shares of the two neighbours give the wanted mean.
                let below = vertices.floor();
                for (vertices, share) in [
                    (below, 1.0 - vertices.fract()),
                    (below + 1.0, vertices.fract()),
                ] {
                    records.sizes.push(SizeRow {
                        distribution: distribution.to_owned(),
                        n,
                        vertices: vertices as usize,
                        replicates: (1_000.0 * share).round() as u64,
                        digest: String::new(),
                    });
                }
            }
        }
        records
    }

    #[test]
    fn each_outcome_can_come_out() {
        let published = Published::load().expect("valid");
        assert_eq!(
            judge(&records(2.0, 0.0), &published).outcome,
            Outcome::Confirmed
        );
        assert_eq!(
            judge(&records(0.2, 0.0), &published).outcome,
            Outcome::Refuted
        );
        assert_eq!(
            judge(&records(1.7, 0.0), &published).outcome,
            Outcome::NotDistinguishable
        );
        assert_eq!(
            judge(&records(2.0, 5.0), &published).outcome,
            Outcome::NotTestable
        );
    }
}
