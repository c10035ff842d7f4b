//! The report on Day. Nothing here runs an algorithm or a clock.

pub(crate) mod figure;
pub(crate) mod merges;
pub(crate) mod others;
pub(crate) mod precision;
pub(crate) mod whole;

use crate::stats::wilson;

/// "share [Wilson's interval]".
fn share(hits: usize, trials: usize) -> String {
    if trials == 0 {
        return String::new();
    }
    let (low, high) = wilson::interval(hits, trials);
    format!("{:.3} [{low:.3}, {high:.3}]", hits as f64 / trials as f64)
}
