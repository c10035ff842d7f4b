//! How steep the data are in logarithms, and how steep each law would be at the same places.

use super::Observation;
use super::law::Law;
use crate::stats::line::{Line, fit_log_log};
use crate::stats::summary::{mean, standard_error};

/// The slope of the data from one size to the next.
#[derive(Clone, Copy, Debug)]
pub struct LocalSlope {
    /// The smaller size.
    pub from: f64,
    /// The larger one.
    pub to: f64,
    /// The slope of ln cost on ln n between them.
    pub slope: f64,
    /// Its standard error, by the scatter of equal sizes; NaN if each was seen once.
    pub error: f64,
}

/// The line through (ln n, ln cost); `None` of fewer than three observations or a single size.
pub fn overall(data: &[Observation]) -> Option<Line> {
    let pairs: Vec<(f64, f64)> = data.iter().map(|place| (place.n, place.cost)).collect();
    fit_log_log(&pairs)
}

/// The slope that `law` would have where `data` are; `None` where it has no value.
///
/// ```
/// use bench_harness::stats::growth::{Law, Observation, slopes::slope_of};
/// let at = |n: f64| Observation { n, h: None, cost: 1.0 };
/// let data: Vec<Observation> = (0..=30).map(|k| at(1e3 * 10_f64.powf(f64::from(k) / 10.0))).collect();
/// let slope = slope_of(Law::NLogN, &data).unwrap();
/// assert!((slope - 1.1).abs() < 0.005);
/// ```
pub fn slope_of(law: Law, data: &[Observation]) -> Option<f64> {
    let as_law = |place: &Observation| {
        let cost = law.at(place)?;
        Some(Observation { cost, ..*place })
    };
    let exact: Option<Vec<Observation>> = data.iter().map(as_law).collect();
    Some(overall(&exact?)?.slope)
}

/// The slopes between neighbouring sizes.
pub fn local(data: &[Observation]) -> Vec<LocalSlope> {
    let mut data = data.to_vec();
    data.sort_unstable_by(|a, b| a.n.total_cmp(&b.n));
    let sizes: Vec<(f64, f64, f64)> = data
        .chunk_by(|a, b| a.n.total_cmp(&b.n).is_eq())
        .map(|group| {
            let logs: Vec<f64> = group.iter().map(|place| place.cost.ln()).collect();
            (group[0].n, mean(&logs), standard_error(&logs))
        })
        .collect();
    let pair = |pair: &[(f64, f64, f64)]| {
        let ((from, low, low_error), (to, high, high_error)) = (pair[0], pair[1]);
        let width = (to / from).ln();
        LocalSlope {
            from,
            to,
            slope: (high - low) / width,
            error: low_error.hypot(high_error) / width,
        }
    };
    sizes.windows(2).map(pair).collect()
}
