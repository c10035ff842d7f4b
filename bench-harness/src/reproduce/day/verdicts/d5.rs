//! D-5: what it costs never to free an edge.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::day::derived::{largest, merged, of_merges};
use crate::reproduce::day::records::{MergeRow, Records};
use crate::stats::line::{Line, fit_on_log};

/// Keeping all is an abundance from so many times on.
const ABUNDANT: f64 = 2.0;

pub(super) fn judge(records: &Records) -> Verdict {
    let mut parts: Vec<Part> = merged(records, "resumed")
        .into_iter()
        .filter_map(|distribution| kept(records, distribution))
        .collect();
    parts.push(grows(records));
    verdict("D-5", parts, notes(records))
}

/// Records made over the most in use at once, if freed.
fn ratio(row: &MergeRow) -> f64 {
    row.edges_made as f64 / row.edges_most.max(1) as f64
}

fn made_a_point(row: &MergeRow) -> f64 {
    row.edges_made as f64 / row.n as f64
}

fn kept(records: &Records, distribution: &str) -> Option<Part> {
    let (n, ratio) = largest(records, distribution, "resumed", ratio)?;
    let outcome = if ratio > ABUNDANT {
        Outcome::Confirmed
    } else {
        Outcome::Refuted
    };
    Some(Part::new(
        format!("{distribution}: keeping every record takes more than twice the room"),
        outcome,
        format!("{ratio:.2} times at n = {n}"),
    ))
}

/// Records made a point on the sphere, against ln n.
fn sphere_line(records: &Records) -> Option<Line> {
    fit_on_log(&of_merges(records, "sphere", "resumed", made_a_point))
}

fn grows(records: &Records) -> Part {
    let what = "sphere: records made a point grow with ln n";
    let Some(line) = sphere_line(records) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not counted at two sizes or more",
        );
    };
    let (low, high) = line.slope_interval(0.95);
    let outcome = if low > 0.0 {
        Outcome::Confirmed
    } else if high < 0.0 {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    let statistic = format!(
        "{:.3} ln n {:+.2}, 95 % of the slope [{low:.3}, {high:.3}]",
        line.slope, line.intercept
    );
    Part::new(what, outcome, statistic)
}

fn notes(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let of =
            |quantity: fn(&MergeRow) -> f64| largest(records, distribution, "resumed", quantity);
        let (n, made) = of(made_a_point)?;
        let (_, most) = of(|row| row.edges_most as f64 / row.n as f64)?;
        let (_, last) = of(|row| row.edges_last as f64 / row.n as f64)?;
        Some(format!(
            "{distribution}, n = {n}: {made:.2} records made a point, {most:.2} in use at most when hidden ones are freed, \
             {last:.2} at the end"
        ))
    };
    merged(records, "resumed")
        .into_iter()
        .filter_map(note)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |made: fn(f64) -> f64| {
            let mut records = Records::default();
            made_up::merges(&mut records, &["ball", "sphere"], "resumed", |n| MergeRow {
                edges_made: (n * made(n)) as u64,
                edges_most: (3.0 * n) as u64,
                ..MergeRow::default()
            });
            judge(&records).outcome
        };
        assert_eq!(judged(|n| 3.0 * n.ln()), Outcome::Confirmed);
        assert_eq!(judged(|n| 5.0 + 0.05 * n.ln()), Outcome::Refuted);
        assert_eq!(judged(|n| 40.0 - 2.0 * n.ln()), Outcome::Refuted);
        let scattered = |n: f64| 10.0 + n.log2().floor() % 2.0;
        assert_eq!(judged(scattered), Outcome::NotDistinguishable);
    }
}
