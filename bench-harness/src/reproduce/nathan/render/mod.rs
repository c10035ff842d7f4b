//! The report on Nathan. Nothing here runs an algorithm on a clock; the picture of Figure 1 is triangulated anew.

pub(crate) mod epsilon;
pub(crate) mod figure1;
pub(crate) mod lifting;
pub(crate) mod sizes;
pub(crate) mod sweep;
pub(crate) mod times;
pub(crate) mod wraps;

/// `part` of `whole` in percent, with one decimal and its 95 % interval.
fn percent(part: usize, whole: usize) -> String {
    let (low, high) = crate::stats::wilson::interval(part, whole);
    let share = part as f64 / whole.max(1) as f64;
    format!(
        "{:.1} [{:.1}, {:.1}]",
        100.0 * share,
        100.0 * low,
        100.0 * high
    )
}
