//! D-9: whether the path that spirals over the hull lists its faces.

use super::{Part, Verdict, always, verdict};
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::{ListingRow, Records};
use crate::stats::summary::mean;

pub(super) fn judge(records: &Records) -> Verdict {
    let rows = &records.own.listings;
    let wrong =
        |is_wrong: &dyn Fn(&ListingRow) -> bool| rows.iter().filter(|row| is_wrong(row)).count();
    let part = |what: &str, wrong: usize| {
        let statistic = format!(
            "not so on {wrong} of {} sets, {} faces in all",
            rows.len(),
            rows.iter().map(|row| row.faces).sum::<usize>()
        );
        Part::new(what, always(wrong, rows.len()), statistic)
    };
    let parts = vec![
        part(
            "the spiral lists the faces of a plain traversal",
            wrong(&|row| row.only_one > 0),
        ),
        part("each of them once", wrong(&|row| row.listed != row.faces)),
        part(
            "and they are the surface of the certified hull",
            wrong(&|row| !row.is_hull),
        ),
    ];
    verdict("D-9", parts, notes(rows))
}

fn notes(rows: &[ListingRow]) -> Vec<String> {
    let note = |distribution: &str| {
        let own = || rows.iter().filter(|row| row.distribution == distribution);
        let largest = own().map(|row| row.n).max().unwrap_or(0);
        let average = |of: fn(&ListingRow) -> f64| {
            let values: Vec<f64> = own().filter(|row| row.n == largest).map(of).collect();
            mean(&values)
        };
        format!(
            "{distribution}, n = {largest}: {:.1} % of the faces share an edge with the one listed before; the recursive \
             procedure would be {:.0} calls deep for {:.0} faces",
            100.0
                * average(|row| row.neighbours as f64 / row.listed.max(2).saturating_sub(1) as f64),
            average(|row| row.deepest as f64),
            average(|row| row.faces as f64)
        )
    };
    let names = in_order(rows.iter().map(|row| &row.distribution));
    names.into_iter().map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Outcome;
    use super::*;
    use crate::reproduce::day::records::Studied;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |sets: usize, spoilt: fn(&mut ListingRow)| {
            let row = ListingRow {
                faces: 10,
                listed: 10,
                is_hull: true,
                ..ListingRow::default()
            };
            let mut listings = vec![row; sets];
            spoilt(&mut listings[0]);
            judge(&Records::from(Studied {
                listings,
                ..Studied::default()
            }))
            .outcome
        };
        assert_eq!(judged(100, |_| ()), Outcome::Confirmed);
        assert_eq!(judged(10, |_| ()), Outcome::NotDistinguishable);
        assert_eq!(judged(100, |row| row.listed = 11), Outcome::Refuted);
        assert_eq!(judged(100, |row| row.only_one = 1), Outcome::Refuted);
        assert_eq!(judged(100, |row| row.is_hull = false), Outcome::Refuted);
    }
}
