//! Whether the fast methods take no longer than they are meant to: in sorts, in passes over the points, or beside a peer.

use super::compare::Comparison;
use super::threads::{self, Gain};
use super::{h_text, ratio_text, text, time_text, typical_time};
use crate::engine::yardstick::Yardstick;
use crate::output::page::{Page, Section, json};
use crate::output::sheet::Sheet;
use crate::records::{Case, Run, Spread};
use serde::{Deserialize, Serialize};

/// What an engine is meant to take on a case.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Target {
    /// The definition of the case.
    pub definition: String,
    /// Its point set.
    pub set: String,
    /// Its number of points.
    pub n: usize,
    /// The engine.
    pub engine: String,
    /// The engine or yardstick whose time is the unit.
    pub unit: String,
    /// So many units at most.
    pub at_most: f64,
}

/// What became of a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Met {
    /// The whole interval of the ratio is below the limit.
    Yes,
    /// The ratio is below the limit, its interval reaches beyond.
    Probably,
    /// The ratio is above the limit.
    No,
    /// Not measured in this run.
    Open,
}

/// A target and what was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What was meant.
    #[serde(flatten)]
    pub target: Target,
    /// Vertices.
    pub h: Option<Spread>,
    /// The typical time of a call, in nanoseconds.
    pub nanoseconds: Option<f64>,
    /// The time in units: ratio and its 95 % interval.
    pub ratio: Option<[f64; 3]>,
    /// Whether it is met.
    pub met: Met,
    /// The fastest engine of others on the case that is certified, and its time over ours.
    pub best_other: Option<(String, f64)>,
    /// Peak memory of the call, in bytes.
    pub peak_bytes: Option<u64>,
    /// The engine of others that is certified on the case and takes the least memory, and how much, in bytes.
    pub least_other: Option<(String, u64)>,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Targets {
    /// A row a target.
    pub rows: Vec<Row>,
    /// What the machine gains by several threads.
    pub gains: Vec<Gain>,
}

/// Holds `run` against those of `targets` that are about its definitions.
pub fn targets(run: &Run, targets: &[Target]) -> Targets {
    let known: Vec<String> = run
        .cases()
        .iter()
        .map(|case| case.definition.clone())
        .collect();
    let own = targets
        .iter()
        .filter(|target| known.contains(&target.definition));
    Targets {
        rows: own.map(|target| row(run, target)).collect(),
        gains: threads::gains(run),
    }
}

fn row(run: &Run, target: &Target) -> Row {
    let case = Case {
        definition: target.definition.clone(),
        set: target.set.clone(),
        n: target.n,
    };
    let compared = Comparison::of(run, &case, &target.engine, &target.unit);
    let ratio = compared.map(|compared| {
        let (low, high) = compared.log.interval(0.95);
        [compared.log.median, low, high].map(f64::exp)
    });
    let ours = typical_time(run, &case, &target.engine);
    Row {
        h: run.h(&case),
        nanoseconds: ours,
        met: match ratio {
            None => Met::Open,
            Some([_, _, high]) if high <= target.at_most => Met::Yes,
            Some([ratio, ..]) if ratio <= target.at_most => Met::Probably,
            Some(_) => Met::No,
        },
        ratio,
        best_other: ours.and_then(|ours| best_other(run, &case, ours)),
        peak_bytes: peak(run, &case, &target.engine),
        least_other: others(run, &case)
            .filter_map(|name| Some((name.to_owned(), peak(run, &case, name)?)))
            .min_by_key(|(_, bytes)| *bytes),
        target: target.clone(),
    }
}

/// The programs of others that were timed on `case`.
fn others<'a>(run: &'a Run, case: &Case) -> impl Iterator<Item = &'a str> {
    let is_other = |name: &&str| hullkit::method(name).is_none() && Yardstick::find(name).is_none();
    run.timed(case).into_iter().filter(is_other)
}

/// The fastest program of others, and its time over `ours`.
fn best_other(run: &Run, case: &Case, ours: f64) -> Option<(String, f64)> {
    let times = others(run, case)
        .filter_map(|name| Some((name.to_owned(), typical_time(run, case, name)? / ours)));
    times.min_by(|a, b| a.1.total_cmp(&b.1))
}

fn peak(run: &Run, case: &Case, engine: &str) -> Option<u64> {
    let counts = run.counts.iter().filter(|count| {
        count.subject.case == *case
            && count.subject.engine == engine
            && count.counter == "peak_bytes"
    });
    counts.map(|count| count.value).max()
}

impl Targets {
    /// Set out as a page.
    pub fn page(&self) -> Page {
        let mut sheet = Sheet::new(&[
            "case",
            "h",
            "method",
            "time",
            "in units [95 %]",
            "unit",
            "at most",
            "met",
            "best other",
            "MB",
            "least of others",
        ]);
        for row in &self.rows {
            let Target {
                set,
                n,
                engine,
                unit,
                at_most,
                ..
            } = &row.target;
            let ratio = row
                .ratio
                .map(|[ratio, low, high]| ratio_text(ratio.ln(), (low.ln(), high.ln())));
            let other = row.best_other.as_ref();
            sheet.push(vec![
                format!("{set} {n}"),
                h_text(row.h),
                engine.clone(),
                time_text(row.nanoseconds),
                text(ratio),
                unit.clone(),
                at_most.to_string(),
                word(row.met).to_owned(),
                text(other.map(|(name, ratio)| format!("{name} {ratio:.1} times ours"))),
                text(row.peak_bytes.map(megabytes)),
                text(
                    row.least_other
                        .as_ref()
                        .map(|(name, bytes)| format!("{} MB ({name})", megabytes(*bytes))),
                ),
            ]);
        }
        let met = self
            .rows
            .iter()
            .filter(|row| matches!(row.met, Met::Yes | Met::Probably))
            .count();
        Page {
            title: "What the fast methods are meant to take".to_owned(),
            preface: vec![
                "A sort is `sort_unstable` of as many random doubles, a pass one reading of the points, both in the same \
                 rounds as the hulls; a peer's name as the unit is that peer's time. Times are from points in memory to \
                 the canonical result, every one of it certified. Memory is what a first call adds to the process, without the \
                 points and without code; less than a megabyte may be what the system has not yet counted."
                    .to_owned(),
            ],
            sections: [
                ("Targets", sheet.clone()),
                (
                    "What the machine gains by threads",
                    threads::sheet(&self.gains),
                ),
            ]
            .into_iter()
            .filter(|(_, sheet)| !sheet.is_empty())
            .map(|(heading, sheet)| Section {
                heading: heading.to_owned(),
                sheet,
                notes: Vec::new(),
            })
            .collect(),
            long: sheet,
            value: json(self),
            headline: format!("{met} of {} targets met", self.rows.len()),
        }
    }
}

/// Less than a megabyte may be what the system does not count at once.
fn megabytes(bytes: u64) -> String {
    match bytes {
        ..1_000_000 => "< 1".to_owned(),
        _ => format!("{:.1}", bytes as f64 / 1e6),
    }
}

fn word(met: Met) -> &'static str {
    match met {
        Met::Yes => "yes",
        Met::Probably => "yes, not surely",
        Met::No => "no",
        Met::Open => "not measured",
    }
}
