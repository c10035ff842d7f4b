//! N-7: the lower hull of the points lifted to z = x² + y² is their Delaunay triangulation.

use super::{Outcome, Part, Verdict, always, verdict};
use crate::reproduce::nathan::records::{LiftRow, Records};
use crate::stats::wilson;

pub(super) fn judge(records: &Records) -> Verdict {
    let near = |row: &&LiftRow| row.offset.abs() <= 1.0;
    let parts = vec![
        part(
            records,
            "without computed heights the triangulation is Delaunay's, wherever the points are",
            |_| true,
            |row| row.exact_right,
        ),
        part(
            records,
            "with heights computed in doubles it is, of points about the origin",
            near,
            |row| row.rounded_right,
        ),
        part(
            records,
            "with heights computed in doubles it is, wherever the points are",
            |row| !near(row),
            |row| row.rounded_right,
        ),
    ];
    let mut notes: Vec<String> = records.own.lifting.iter().filter_map(signs).collect();
    notes.extend(records.own.grids.iter().map(|row| {
        format!(
            "a grid of spacing {} from {}: of {} cells with cocircular corners {} have lifts out of one plane ({:.1} %)",
            row.spacing,
            row.offset,
            row.cocircular,
            row.wrong_signs,
            100.0 * row.wrong_signs as f64 / row.cocircular.max(1) as f64
        )
    }));
    verdict("N-7", parts, notes)
}

fn part(
    records: &Records,
    what: &str,
    keep: impl Fn(&&LiftRow) -> bool,
    right: fn(&LiftRow) -> usize,
) -> Part {
    let rows = || records.own.lifting.iter().filter(&keep);
    let sets: usize = rows().map(|row| row.sets).sum();
    let right: usize = rows().map(right).sum();
    let outcome = match always(sets - right, sets) {
        // Certificates of larger sets: a dozen of them hold ten thousand and more empty circles.
        Outcome::NotDistinguishable if rows().map(|row| row.quadruples).sum::<u64>() >= 10_000 => {
            Outcome::Confirmed
        }
        outcome => outcome,
    };
    Part::new(what, outcome, format!("certified {right} of {sets} sets"))
}

/// The share of wrong signs of a row, if there are any.
fn signs(row: &LiftRow) -> Option<String> {
    let share = share_of_wrong_signs(row)?;
    let (low, high) = wilson::interval(row.wrong_signs as usize, row.quadruples as usize);
    (row.wrong_signs > 0).then(|| {
        format!(
            "{} {}, offset {:e}: {:.2} % of the in-circle questions wrong [{:.2}, {:.2}], {} of {} sets triangulated right",
            row.distribution,
            row.n,
            row.offset,
            100.0 * share,
            100.0 * low,
            100.0 * high,
            row.rounded_right,
            row.sets
        )
    })
}

/// Wrong signs over questions.
pub(crate) fn share_of_wrong_signs(row: &LiftRow) -> Option<f64> {
    (row.quadruples > 0).then(|| row.wrong_signs as f64 / row.quadruples as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::nathan::records::Studied;

    fn judged(exact_right: usize, near: usize, far: usize, quadruples: u64) -> Verdict {
        let row = |offset, rounded_right| LiftRow {
            offset,
            sets: 20,
            exact_right,
            rounded_right,
            quadruples,
            ..LiftRow::default()
        };
        judge(&Records::from(Studied {
            lifting: vec![row(0.0, near), row(1e7, far)],
            ..Studied::default()
        }))
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(20, 20, 20, 20_000).outcome, Outcome::Confirmed);
        assert_eq!(judged(20, 20, 20, 200).outcome, Outcome::NotDistinguishable);
        let far = judged(20, 20, 0, 20_000);
        let outcomes: Vec<Outcome> = far.parts.iter().map(|part| part.outcome).collect();
        assert_eq!(
            outcomes,
            [Outcome::Confirmed, Outcome::Confirmed, Outcome::Refuted]
        );
        assert_eq!(
            judged(19, 20, 20, 20_000).parts[0].outcome,
            Outcome::Refuted
        );
    }
}
