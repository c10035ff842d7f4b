//! What has changed between two runs.
//!
//! A cell is one engine on one case; it is matched by definition, set, n, seed and engine, and by the fingerprint of
//! its points. Times of two runs share no rounds, so the statistic is the ratio of the median times, realisation by
//! realisation, and its geometric mean over them; its interval draws realisations again, and the rounds of each side
//! within each. The realisations are the same points in both runs, so that all freedom is that of the rounds.
//!
//! What is established:
//!
//! 1. The A/A band holds 95 % of the ratios of a program to itself within either run, at least 2 % either side.
//! 2. A cell is slower (faster) if a true ratio inside the band has p < 0.05, adjusted for all matched cells (Holm), and
//!    the 95 % interval lies outside the band.
//! 3. A cell is lost if it was certified on some realisation and is not so any more.

mod page;

use super::band::Band;
use super::{seed_of, typical_time};
use crate::records::{Case, Outcome, Run, Spread, Subject};
use crate::stats::bootstrap::clustered_shift;
use crate::stats::holm;
use crate::stats::interval::p_beyond;
use crate::stats::summary::median;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fmt;

/// If more than this part of the cells move the same way, the machine is suspected.
const MOST: f64 = 0.75;

/// What has become of a cell's time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Change {
    /// Nothing that is established.
    None,
    /// It is slower.
    Slower,
    /// It is faster.
    Faster,
}

/// One engine on one case, timed in both runs.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// The engine.
    pub engine: String,
    /// How many vertices the hulls have.
    pub h: Option<Spread>,
    /// The typical time of a call before, in nanoseconds.
    pub before: f64,
    /// And now.
    pub after: f64,
    /// Realisations timed in both runs.
    pub realisations: usize,
    /// Now over before.
    pub ratio: f64,
    /// The lower end of its 95 % interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The p-value of a true ratio inside the band, adjusted for all cells.
    pub p_value: f64,
    /// What is established.
    pub change: Change,
}

/// A count that is no longer what it was.
#[derive(Clone, Debug, Serialize)]
pub struct CountChange {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// The engine.
    pub engine: String,
    /// What was counted.
    pub counter: String,
    /// The sum before, over the realisations that differ.
    pub before: u64,
    /// The sum now.
    pub after: u64,
    /// How many realisations differ.
    pub realisations: usize,
}

/// A cell whose result was certified, and is no longer.
#[derive(Clone, Debug, Serialize)]
pub struct Lost {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// The seed.
    pub seed: u64,
    /// The engine.
    pub engine: String,
    /// What has become of it.
    pub outcome: String,
    /// What was found.
    pub finding: String,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Diff {
    /// Inside it nothing is claimed.
    pub band: Band,
    /// Every cell timed in both runs.
    pub rows: Vec<Row>,
    /// Counts that differ.
    pub counts: Vec<CountChange>,
    /// Certificates that are gone.
    pub lost: Vec<Lost>,
    /// What else a reader must know: other machines, other points, cells of one run only.
    pub notes: Vec<String>,
}

/// Compares `new` with `old`.
pub fn diff(old: &Run, new: &Run) -> Diff {
    let band = Band::of(&[old, new]);
    let other_points = other_points(old, new);
    let mut rows = Vec::new();
    let mut unmatched = 0;
    for case in new.cases() {
        for engine in new.timed(case) {
            match compare_cell(old, new, case, engine, band, &other_points) {
                Some(row) => rows.push(row),
                None => unmatched += 1,
            }
        }
    }
    establish(&mut rows, band);
    let mut notes = machine_notes(old, new);
    if unmatched > 0 {
        notes.push(format!("{unmatched} cells were timed in the new run only"));
    }
    if !other_points.is_empty() {
        notes.push(format!(
            "{} cells have other points than before, under the same seed, and are not compared",
            other_points.len()
        ));
    }
    notes.extend(common_shift(&rows, band));
    Diff {
        band,
        rows,
        counts: count_changes(old, new),
        lost: lost(old, new),
        notes,
    }
}

/// The realisations whose fingerprint differs between the runs.
fn other_points(old: &Run, new: &Run) -> BTreeSet<(Case, u64)> {
    let key = |subject: &Subject| (subject.case.clone(), subject.seed);
    let before: HashMap<_, &str> = old
        .cells
        .iter()
        .map(|cell| (key(&cell.subject), cell.fingerprint.as_str()))
        .collect();
    let differs = |cell: &&crate::records::Cell| {
        before
            .get(&key(&cell.subject))
            .is_some_and(|fingerprint| *fingerprint != cell.fingerprint)
    };
    let differing = new.cells.iter().filter(differs);
    differing.map(|cell| key(&cell.subject)).collect()
}

fn compare_cell(
    old: &Run,
    new: &Run,
    case: &Case,
    engine: &str,
    band: Band,
    other_points: &BTreeSet<(Case, u64)>,
) -> Option<Row> {
    let logs = |run: &Run| -> BTreeMap<u64, Vec<f64>> {
        let of = |times: Vec<f64>| times.into_iter().map(f64::ln).collect();
        let realisations = run.times(case, engine).iter();
        realisations
            .filter(|realisation| !other_points.contains(&(case.clone(), realisation.seed)))
            .map(|realisation| (realisation.seed, of(realisation.times())))
            .collect()
    };
    let (before, mut after) = (logs(old), logs(new));
    let clusters: Vec<(Vec<f64>, Vec<f64>)> = before
        .into_iter()
        .filter_map(|(seed, times)| Some((times, after.remove(&seed)?)))
        .collect();
    let shift = clustered_shift(&clusters, seed_of(&[&case.to_string(), engine]))?;
    let rounds: usize = clusters.iter().map(|(a, b)| a.len().min(b.len())).sum();
    let freedom = rounds.saturating_sub(clusters.len()) as f64;
    let (low, high) = shift.interval(0.95);
    let error = shift.standard_error();
    Some(Row {
        case: case.clone(),
        engine: engine.to_owned(),
        h: new.h(case),
        before: typical_time(old, case, engine)?,
        after: typical_time(new, case, engine)?,
        realisations: clusters.len(),
        ratio: shift.median.exp(),
        low: low.exp(),
        high: high.exp(),
        p_value: p_beyond(shift.median, error, freedom, band.half_width),
        change: Change::None,
    })
}

/// Adjusts the p-values for all cells and says what is established (2).
fn establish(rows: &mut [Row], band: Band) {
    let p_values: Vec<f64> = rows.iter().map(|row| row.p_value).collect();
    for (row, p_value) in rows.iter_mut().zip(holm::adjusted(&p_values)) {
        row.p_value = p_value;
        let is_sure = p_value < 0.05;
        row.change = if is_sure && row.low.ln() > band.half_width {
            Change::Slower
        } else if is_sure && row.high.ln() < -band.half_width {
            Change::Faster
        } else {
            Change::None
        };
    }
}

fn machine_notes(old: &Run, new: &Run) -> Vec<String> {
    let (a, b) = (&old.manifest, &new.manifest);
    let different = [
        ("processor", &a.processor, &b.processor),
        ("compiler", &a.compiler, &b.compiler),
        ("flags", &a.flags, &b.flags),
        ("kernel", &a.kernel, &b.kernel),
    ];
    let note = |(what, a, b): (&str, &String, &String)| {
        (a != b).then(|| format!("the {what} differs: {a:?} before, {b:?} now"))
    };
    different.into_iter().filter_map(note).collect()
}

/// A note if most cells have moved beyond the band to one side: then it may be the machine.
fn common_shift(rows: &[Row], band: Band) -> Option<String> {
    let logs: Vec<f64> = rows.iter().map(|row| row.ratio.ln()).collect();
    let engines: BTreeSet<&str> = rows.iter().map(|row| row.engine.as_str()).collect();
    let middle = median(&logs);
    let moved = logs
        .iter()
        .filter(|log| log.signum() == middle.signum() && log.abs() > band.half_width);
    let moved = moved.count();
    (engines.len() > 1 && moved as f64 > MOST * logs.len() as f64).then(|| {
        format!(
            "{moved} of {} cells have moved the same way, the middle one by a factor of {:.3}: it may be the machine and \
             not the engines",
            logs.len(),
            middle.exp()
        )
    })
}

fn count_changes(old: &Run, new: &Run) -> Vec<CountChange> {
    let before: HashMap<_, u64> = old
        .counts
        .iter()
        .map(|count| ((&count.subject, count.counter.as_str()), count.value))
        .collect();
    let mut changes: BTreeMap<(&Case, &str, &str), (u64, u64, usize)> = BTreeMap::new();
    for count in &new.counts {
        let subject = &count.subject;
        let Some(&value) = before.get(&(subject, count.counter.as_str())) else {
            continue;
        };
        if value != count.value {
            let change = changes
                .entry((&subject.case, &subject.engine, &count.counter))
                .or_default();
            *change = (change.0 + value, change.1 + count.value, change.2 + 1);
        }
    }
    let change = |((case, engine, counter), (before, after, realisations)): (
        (&Case, &str, &str),
        (u64, u64, usize),
    )| CountChange {
        case: case.clone(),
        engine: engine.to_owned(),
        counter: counter.to_owned(),
        before,
        after,
        realisations,
    };
    changes.into_iter().map(change).collect()
}

fn lost(old: &Run, new: &Run) -> Vec<Lost> {
    let certified: BTreeSet<&Subject> = old
        .cells
        .iter()
        .filter(|cell| cell.outcome == Outcome::Certified)
        .map(|cell| &cell.subject)
        .collect();
    let gone = new
        .cells
        .iter()
        .filter(|cell| cell.outcome != Outcome::Certified && certified.contains(&cell.subject));
    gone.map(|cell| Lost {
        case: cell.subject.case.clone(),
        seed: cell.subject.seed,
        engine: cell.subject.engine.clone(),
        outcome: cell.outcome.to_string(),
        finding: cell.finding.clone(),
    })
    .collect()
}

impl Diff {
    /// The cells that have changed in this way.
    pub fn changed(&self, change: Change) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.change == change)
    }

    /// Why the new run is worse, if it is: slower cells, lost certificates.
    pub fn regression(&self) -> Option<String> {
        let slower: Vec<&Row> = self.changed(Change::Slower).collect();
        let mut parts = Vec::new();
        if let Some(worst) = slower.iter().max_by(|a, b| a.ratio.total_cmp(&b.ratio)) {
            let engines: BTreeSet<&str> = slower.iter().map(|row| row.engine.as_str()).collect();
            let engines: Vec<&str> = engines.into_iter().collect();
            parts.push(format!(
                "{} of {} cells are slower ({}; the worst by {:.3} on {})",
                slower.len(),
                self.rows.len(),
                engines.join(", "),
                worst.ratio,
                worst.case
            ));
        }
        if let Some(first) = self.lost.first() {
            parts.push(format!(
                "{} certificates are lost (the first of {} on {})",
                self.lost.len(),
                first.engine,
                first.case
            ));
        }
        (!parts.is_empty()).then(|| parts.join("; "))
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Change::None => "none",
            Change::Slower => "slower",
            Change::Faster => "faster",
        })
    }
}
