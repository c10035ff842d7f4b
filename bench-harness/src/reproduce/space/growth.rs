//! Growth with n: the data of counted runs, their exponent, and what is said of it: that it has a value, that a bound
//! holds, that a cost is O(n log n). Which law a cost follows is another question: [`crate::stats::growth`] answers it.

use crate::reproduce::rows::CountRow;
use crate::reproduce::verdict::{Outcome, Part};
use crate::stats::interval::{Place, equivalence};
use crate::stats::line::{Line, fit_log_log};
use crate::stats::summary::{deviation, mean};
use std::collections::BTreeMap;

/// All questions of every kind.
pub(crate) fn questions(row: &CountRow) -> f64 {
    row.questions() as f64
}

/// n and `quantity` of each run.
pub(crate) fn against_n<'a>(
    runs: impl Iterator<Item = &'a CountRow>,
    quantity: impl Fn(&CountRow) -> f64,
) -> Vec<(f64, f64)> {
    runs.map(|row| (row.n as f64, quantity(row))).collect()
}

/// The values of each n, by n.
pub(crate) fn groups(data: &[(f64, f64)]) -> Vec<(f64, Vec<f64>)> {
    let mut groups: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
    for &(n, value) in data {
        groups.entry(n as u64).or_default().push(value);
    }
    groups
        .into_iter()
        .map(|(n, values)| (n as f64, values))
        .collect()
}

/// The mean of the values of each n.
pub(crate) fn means(data: &[(f64, f64)]) -> Vec<(f64, f64)> {
    groups(data)
        .into_iter()
        .map(|(n, values)| (n, mean(&values)))
        .collect()
}

/// The mean at the largest n.
pub(crate) fn at_largest(data: &[(f64, f64)]) -> Option<(f64, f64)> {
    means(data).last().copied()
}

/// The data of the two upper decades of n: where an asymptotic statement is to be looked for.
pub(crate) fn upper_decades(data: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let largest = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    data.iter()
        .copied()
        .filter(|(n, _)| 100.5 * n >= largest)
        .collect()
}

/// "n from … to …", for the sizes in `data`.
pub(crate) fn range(data: &[(f64, f64)]) -> String {
    let least = data.iter().map(|(n, _)| *n).fold(f64::INFINITY, f64::min);
    let most = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    format!("n from {least} to {most}")
}

/// The exponent of growth over the two upper decades, with its interval at 90 %.
#[derive(Clone, Debug)]
pub(crate) struct Exponent {
    pub(crate) value: f64,
    pub(crate) interval: (f64, f64),
    /// The sizes it was fitted on.
    pub(crate) range: String,
}

impl std::fmt::Display for Exponent {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (low, high) = self.interval;
        write!(
            f,
            "{:.3}, 90 % [{low:.3}, {high:.3}], {}",
            self.value, self.range
        )
    }
}

/// The exponent of `data` in n; `None` for less than two sizes or three runs.
pub(crate) fn exponent(data: &[(f64, f64)]) -> Option<Exponent> {
    let data = upper_decades(data);
    let line: Line = fit_log_log(&data)?;
    Some(Exponent {
        value: line.slope,
        interval: line.slope_interval(0.90),
        range: range(&data),
    })
}

/// What it takes to fit an exponent.
const TOO_FEW: &str = "not counted at two sizes or more";

/// Whether `data` grows as n to the `target`, give or take `margin` (two one-sided tests at 5 %).
pub(crate) fn grows_as(
    what: impl Into<String>,
    data: &[(f64, f64)],
    target: f64,
    margin: f64,
) -> Part {
    let Some(exponent) = exponent(data) else {
        return Part::new(what, Outcome::NotTestable, TOO_FEW);
    };
    let outcome = match equivalence(exponent.interval, target, margin) {
        Place::Within => Outcome::Confirmed,
        Place::Outside => Outcome::Refuted,
        Place::Across => Outcome::NotDistinguishable,
    };
    let statistic = format!("exponent {exponent}; band {target} ± {margin}");
    Part::new(what, outcome, statistic)
}

/// Whether `data`, a cost over its bound, does not rise: exponent at most `margin`. A bound is not refuted by lying
/// far above.
pub(crate) fn does_not_rise(what: impl Into<String>, data: &[(f64, f64)], margin: f64) -> Part {
    let Some(exponent) = exponent(data) else {
        return Part::new(what, Outcome::NotTestable, TOO_FEW);
    };
    let (low, high) = exponent.interval;
    let outcome = if high <= margin {
        Outcome::Confirmed
    } else if low > margin {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    let statistic = format!(
        "cost over bound: exponent {exponent}, at most {margin} wanted; {}",
        ratios(data)
    );
    Part::new(what, outcome, statistic)
}

/// Whether `data`, a cost, is O(n log n).
///
/// It is if the cost over n log n does not rise. If it rises, a term in n with a negative factor may be the reason: then
/// the cost a point still grows by no more for one unit of ln n at the large sizes than at the small ones, while for
/// n log² n it would grow by as much more as ln n is larger.
pub(crate) fn is_n_log_n(what: impl Into<String>, data: &[(f64, f64)]) -> Part {
    let over: Vec<(f64, f64)> = data.iter().map(|(n, y)| (*n, y / (n * n.ln()))).collect();
    let simple = does_not_rise(what, &over, 0.05);
    if matches!(simple.outcome, Outcome::Confirmed | Outcome::NotTestable) {
        return simple;
    }
    let Some(bend) = Bend::of(data) else {
        return simple;
    };
    let (low, high) = (
        bend.ratio - 1.645 * bend.error,
        bend.ratio + 1.645 * bend.error,
    );
    let between = (1.0 + bend.of_squared_log) / 2.0;
    let outcome = if high <= between {
        Outcome::Confirmed
    } else if low > between {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    let statistic = format!(
        "cost a point grows for one unit of ln n {:.3} times as much, 90 % [{low:.3}, {high:.3}], in the upper as in the \
         lower half of {}; n log n: 1, n log² n: {:.3}, decided at {between:.3}",
        bend.ratio, bend.range, bend.of_squared_log
    );
    Part::new(simple.what, outcome, statistic)
}

/// How much faster the cost a point grows with ln n at the large sizes of the two upper decades than at the small ones.
struct Bend {
    ratio: f64,
    /// Its standard error, by the scatter of equal sizes.
    error: f64,
    /// What the ratio is for n log² n.
    of_squared_log: f64,
    range: String,
}

impl Bend {
    /// `None` with less than three sizes, or without growth in the lower half.
    fn of(data: &[(f64, f64)]) -> Option<Self> {
        let a_point: Vec<(f64, f64)> = data.iter().map(|(n, y)| (*n, y / n)).collect();
        let sizes: Vec<(f64, Vec<f64>)> = groups(&upper_decades(&a_point)).into_iter().collect();
        let ([first, ..], [.., last]) = (&sizes[..], &sizes[..]) else {
            return None;
        };
        let center = (first.0.ln() + last.0.ln()) / 2.0;
        let off = |size: &&(f64, Vec<f64>)| (size.0.ln() - center).abs();
        let inner = sizes.get(1..sizes.len() - 1)?;
        let middle = inner.iter().min_by(|a, b| off(a).total_cmp(&off(b)))?;
        let scatters = sizes
            .iter()
            .map(|(_, values)| deviation(values) / mean(values));
        let known: Vec<f64> = scatters.filter(|scatter| scatter.is_finite()).collect();
        let scatter = if known.is_empty() { 0.0 } else { mean(&known) };

        let [l1, l2, l3] = [first, middle, last].map(|(n, _)| n.ln());
        let [y1, y2, y3] = [first, middle, last].map(|(_, values)| mean(values));
        let [e1, e2, e3] = [first, middle, last]
            .map(|(_, values)| scatter * mean(values) / (values.len() as f64).sqrt());
        let (lower, upper) = ((y2 - y1) / (l2 - l1), (y3 - y2) / (l3 - l2));
        if lower <= 0.0 {
            return None;
        }
        let ratio = upper / lower;
        let errors = [
            e3 / (l3 - l2) / lower,
            e2 * (1.0 / (l3 - l2) + ratio / (l2 - l1)) / lower,
            e1 * ratio / (l2 - l1) / lower,
        ];
        Some(Self {
            ratio,
            error: errors.iter().map(|error| error * error).sum::<f64>().sqrt(),
            of_squared_log: (l3 + l2) / (l2 + l1),
            range: format!("n from {} to {}", first.0, last.0),
        })
    }
}

/// The least and the largest of the values.
fn ratios(data: &[(f64, f64)]) -> String {
    let least = data.iter().map(|(_, y)| *y).fold(f64::INFINITY, f64::min);
    let most = data.iter().map(|(_, y)| *y).fold(0.0, f64::max);
    format!("ratio from {least:.3e} to {most:.3e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(exponent: f64, spread: f64) -> Vec<(f64, f64)> {
        let sizes = [100.0_f64, 1_000.0, 10_000.0];
        let values =
            |n: f64| [-1.0, 0.0, 1.0].map(|step| (n, n.powf(exponent) * (1.0 + spread * step)));
        sizes.into_iter().flat_map(values).collect()
    }

    #[test]
    fn each_outcome_can_come_out() {
        let grows = |e, spread| grows_as("x", &power(e, spread), 2.0, 0.05).outcome;
        assert_eq!(grows(2.0, 0.01), Outcome::Confirmed);
        assert_eq!(grows(1.5, 0.01), Outcome::Refuted);
        assert_eq!(grows(2.0, 0.9), Outcome::NotDistinguishable);
        let bounded = |e, spread| does_not_rise("x", &power(e, spread), 0.02).outcome;
        assert_eq!(bounded(-0.5, 0.01), Outcome::Confirmed);
        assert_eq!(bounded(0.0, 0.01), Outcome::Confirmed);
        assert_eq!(bounded(0.2, 0.01), Outcome::Refuted);
        assert_eq!(bounded(0.0, 0.9), Outcome::NotDistinguishable);
        assert_eq!(does_not_rise("x", &[], 0.1).outcome, Outcome::NotTestable);
    }

    #[test]
    fn n_log_n_is_told_from_more_and_from_a_negative_term() {
        let cost = |a_point: fn(f64) -> f64, spread: f64| {
            let sizes = [100.0_f64, 1_000.0, 10_000.0];
            let values =
                |n: f64| [-1.0, 1.0].map(|step| (n, n * a_point(n.ln()) * (1.0 + spread * step)));
            let data: Vec<(f64, f64)> = sizes.into_iter().flat_map(values).collect();
            is_n_log_n("x", &data).outcome
        };
        assert_eq!(cost(|log| log, 0.001), Outcome::Confirmed);
        assert_eq!(cost(|_| 5.0, 0.001), Outcome::Confirmed);
        assert_eq!(cost(|log| 20.0 * log - 60.0, 0.001), Outcome::Confirmed);
        assert_eq!(cost(|log| log * log, 0.001), Outcome::Refuted);
        assert_eq!(cost(|log| log.exp().sqrt(), 0.001), Outcome::Refuted);
        assert_eq!(
            cost(|log| 20.0 * log - 60.0, 0.3),
            Outcome::NotDistinguishable
        );
        assert_eq!(is_n_log_n("x", &[]).outcome, Outcome::NotTestable);
    }
}
