//! What the machine gains by several threads, by yardsticks that are measured on one and on all of them.
//!
//! A method on several threads will hardly gain more than arithmetic in registers does, nor, where it reads memory, more than a
//! pass over the points.

use super::compare::Comparison;
use super::{ratio_text, time_text, typical_time};
use crate::engine::yardstick::YARDSTICKS;
use crate::output::sheet::Sheet;
use crate::records::{Case, Run};
use serde::Serialize;

/// What ends the name of the yardstick on all threads.
const PARALLEL: &str = "-parallel";

/// The time of a yardstick on all threads over that on one.
#[derive(Clone, Debug, Serialize)]
pub struct Gain {
    /// The case.
    pub case: String,
    /// The yardstick on one thread.
    pub work: &'static str,
    /// Its typical time, in nanoseconds.
    pub one: f64,
    /// That on all threads.
    pub all: f64,
    /// The second over the first: ratio and its 95 % interval.
    pub ratio: [f64; 3],
}

/// Every yardstick that was measured both ways, case by case.
pub fn gains(run: &Run) -> Vec<Gain> {
    let cases = run.cases().into_iter();
    cases
        .flat_map(|case| {
            let works = YARDSTICKS.iter().map(|(_, name, _)| *name);
            works.filter_map(move |work| gain(run, case, work))
        })
        .collect()
}

fn gain(run: &Run, case: &Case, work: &'static str) -> Option<Gain> {
    let on_all = format!("{work}{PARALLEL}");
    let compared = Comparison::of(run, case, &on_all, work)?;
    let (low, high) = compared.log.interval(0.95);
    Some(Gain {
        case: case.to_string(),
        work,
        one: typical_time(run, case, work)?,
        all: typical_time(run, case, &on_all)?,
        ratio: [compared.log.median, low, high].map(f64::exp),
    })
}

/// Set out as a table.
pub fn sheet(gains: &[Gain]) -> Sheet {
    let mut sheet = Sheet::new(&["case", "work", "one thread", "all threads", "ratio [95 %]"]);
    for gain in gains {
        let [ratio, low, high] = gain.ratio.map(f64::ln);
        sheet.push(vec![
            gain.case.clone(),
            gain.work.to_owned(),
            time_text(Some(gain.one)),
            time_text(Some(gain.all)),
            ratio_text(ratio, (low, high)),
        ]);
    }
    sheet
}
