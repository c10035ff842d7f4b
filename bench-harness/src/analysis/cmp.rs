//! How the engines compare, case by case.

use super::band::Band;
use super::compare::Comparison;
use super::{h_text, ratio_text, text, time_text, typical_time};
use crate::output::page::{Page, Section, json};
use crate::output::sheet::Sheet;
use crate::records::{Case, Outcome, Run, Spread};
use crate::stats::holm;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;

/// How an engine stands to the baseline of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// It is the baseline.
    Baseline,
    /// Surely faster, by more than the A/A band.
    Faster,
    /// Surely slower, by more than the A/A band.
    Slower,
    /// Neither is sure.
    Open,
}

/// One engine on one case.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// How many vertices its hulls have.
    pub h: Option<Spread>,
    /// The engine.
    pub engine: String,
    /// The typical time of a call, in nanoseconds.
    pub nanoseconds: f64,
    /// The shortest, over all samples.
    pub shortest: f64,
    /// Realisations.
    pub realisations: usize,
    /// The engine that it is compared with.
    pub baseline: String,
    /// Its time over the baseline's; none for the baseline, and if they share no round.
    pub ratio: Option<Ratio>,
    /// How it stands to the baseline.
    pub standing: Standing,
}

/// A ratio of times with what is known about it.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ratio {
    /// The ratio.
    pub ratio: f64,
    /// The lower end of its 95 % interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The p-value of a ratio inside the A/A band, adjusted for all cells (Holm).
    pub p_value: f64,
    /// That of no difference, by signed ranks, not adjusted.
    pub wilcoxon: f64,
    /// The rank correlation of ratio and round, if there are enough rounds.
    pub drift: Option<f64>,
    /// Its p-value.
    pub drift_p: Option<f64>,
}

/// An engine that was not certified on a case.
#[derive(Clone, Debug, Serialize)]
pub struct Uncertified {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// The engine.
    pub engine: String,
    /// What became of it.
    pub outcome: String,
    /// On so many realisations.
    pub realisations: usize,
    /// What was found on the first of them.
    pub finding: String,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Cmp {
    /// Inside it nothing is claimed.
    pub band: Band,
    /// Case by case, the fastest engine first.
    pub rows: Vec<Row>,
    /// What was not measured, because it was not proved right.
    pub uncertified: Vec<Uncertified>,
}

/// Compares every engine with `baseline`, or with the fastest one of each case.
pub fn cmp(run: &Run, baseline: Option<&str>) -> Cmp {
    let band = Band::of(&[run]);
    let mut rows = Vec::new();
    for case in run.cases() {
        rows.extend(compare_case(run, case, baseline, band));
    }
    adjust(&mut rows);
    Cmp {
        band,
        rows,
        uncertified: uncertified(run),
    }
}

fn compare_case(run: &Run, case: &Case, baseline: Option<&str>, band: Band) -> Vec<Row> {
    let time = |engine: &str| typical_time(run, case, engine).unwrap_or(f64::INFINITY);
    let mut engines = run.timed(case);
    engines.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let named = baseline.filter(|name| engines.contains(name));
    let Some(baseline) = named.or_else(|| engines.first().copied()) else {
        return Vec::new();
    };
    let h = run.h(case);
    let row = |engine: &str| {
        let compared = (engine != baseline)
            .then(|| Comparison::of(run, case, engine, baseline))
            .flatten();
        let times = run.times(case, engine);
        let samples = times.iter().flat_map(|realisation| &realisation.rounds);
        Row {
            case: case.clone(),
            h,
            engine: engine.to_owned(),
            nanoseconds: time(engine),
            shortest: samples.map(|(_, time)| *time).fold(f64::INFINITY, f64::min),
            realisations: times.len(),
            baseline: baseline.to_owned(),
            ratio: compared.map(|compared| Ratio::of(&compared, band)),
            standing: if engine == baseline {
                Standing::Baseline
            } else {
                Standing::Open
            },
        }
    };
    engines.iter().map(|engine| row(engine)).collect()
}

/// Adjusts the p-values for all cells together, and says who stands how.
fn adjust(rows: &mut [Row]) {
    let compared = rows.iter_mut().filter_map(|row| {
        let ratio = row.ratio.as_mut()?;
        Some((ratio, &mut row.standing))
    });
    let mut compared: Vec<_> = compared.collect();
    let p_values: Vec<f64> = compared.iter().map(|(ratio, _)| ratio.p_value).collect();
    for ((ratio, standing), p_value) in compared.iter_mut().zip(holm::adjusted(&p_values)) {
        ratio.p_value = p_value;
        **standing = match p_value < 0.05 {
            true if ratio.ratio > 1.0 => Standing::Slower,
            true => Standing::Faster,
            false => Standing::Open,
        };
    }
}

impl Ratio {
    fn of(compared: &Comparison, band: Band) -> Self {
        let (low, high) = compared.log.interval(0.95);
        Self {
            ratio: compared.log.median.exp(),
            low: low.exp(),
            high: high.exp(),
            p_value: compared.p_beyond(band.half_width),
            wilcoxon: compared.wilcoxon,
            drift: compared.drift.map(|drift| drift.rho),
            drift_p: compared.drift.map(|drift| drift.p_value),
        }
    }

    fn text(&self) -> String {
        ratio_text(self.ratio.ln(), (self.low.ln(), self.high.ln()))
    }

    /// Whether the ratio surely moved while it was measured.
    fn drifts(&self) -> bool {
        self.drift_p.is_some_and(|p_value| p_value < 0.001)
    }
}

fn uncertified(run: &Run) -> Vec<Uncertified> {
    let failed = |cell: &&crate::records::Cell| cell.outcome != Outcome::Certified;
    let mut found: Vec<Uncertified> = Vec::new();
    let mut seen = BTreeSet::new();
    for cell in run.cells.iter().filter(failed) {
        let key = (&cell.subject.case, &cell.subject.engine, cell.outcome);
        let same = |row: &&mut Uncertified| {
            row.case == *key.0 && row.engine == *key.1 && row.outcome == key.2.to_string()
        };
        if !seen.insert(key)
            && let Some(row) = found.iter_mut().find(same)
        {
            row.realisations += 1;
            continue;
        }
        found.push(Uncertified {
            case: cell.subject.case.clone(),
            engine: cell.subject.engine.clone(),
            outcome: cell.outcome.to_string(),
            realisations: 1,
            finding: cell.finding.clone(),
        });
    }
    found
}

impl Cmp {
    /// The answer for readers and programs.
    pub fn page(&self) -> Page {
        let mut sections: Vec<Section> = self
            .rows
            .chunk_by(|a, b| a.case == b.case)
            .map(case_section)
            .collect();
        if !self.uncertified.is_empty() {
            sections.push(self.uncertified_section());
        }
        Page {
            title: "Engines side by side".into(),
            preface: vec![
                self.band.sentence(),
                "Ratio: median over rounds of the time over the baseline's in the same round, with its 95 % interval \
                 over realisations and rounds. Slower or faster: beyond the band, p < 0.05 adjusted for all cells (Holm)."
                    .into(),
            ],
            sections,
            long: self.long(),
            value: json(self),
            headline: format!(
                "{} times, of which {} surely differ from their baseline",
                self.rows.len(),
                self.rows
                    .iter()
                    .filter(|row| matches!(row.standing, Standing::Faster | Standing::Slower))
                    .count()
            ),
        }
    }

    fn uncertified_section(&self) -> Section {
        let mut sheet = Sheet::new(&["case", "engine", "outcome", "sets", "finding"]);
        for row in &self.uncertified {
            sheet.push(vec![
                row.case.to_string(),
                row.engine.clone(),
                row.outcome.clone(),
                row.realisations.to_string(),
                row.finding.clone(),
            ]);
        }
        Section {
            heading: "Not certified, therefore not timed".into(),
            sheet,
            notes: Vec::new(),
        }
    }

    fn long(&self) -> Sheet {
        let mut sheet = Sheet::new(&[
            "definition",
            "set",
            "n",
            "h",
            "engine",
            "nanoseconds",
            "shortest",
            "realisations",
            "baseline",
            "ratio",
            "low",
            "high",
            "p",
            "wilcoxon_p",
            "drift",
            "standing",
        ]);
        for row in &self.rows {
            let of = |part: fn(&Ratio) -> f64| text(row.ratio.as_ref().map(part));
            sheet.push(vec![
                row.case.definition.clone(),
                row.case.set.clone(),
                row.case.n.to_string(),
                text(row.h.map(|h| h.middle)),
                row.engine.clone(),
                row.nanoseconds.to_string(),
                row.shortest.to_string(),
                row.realisations.to_string(),
                row.baseline.clone(),
                of(|ratio| ratio.ratio),
                of(|ratio| ratio.low),
                of(|ratio| ratio.high),
                of(|ratio| ratio.p_value),
                of(|ratio| ratio.wilcoxon),
                text(row.ratio.and_then(|ratio| ratio.drift)),
                row.standing.to_string(),
            ]);
        }
        sheet
    }
}

/// The engines of one case.
fn case_section(rows: &[Row]) -> Section {
    let mut sheet = Sheet::new(&[
        "engine",
        "median",
        "shortest",
        "a point",
        "over the baseline",
        "p",
        "standing",
    ]);
    let case = &rows[0].case;
    let mut notes = Vec::new();
    for row in rows {
        sheet.push(vec![
            row.engine.clone(),
            time_text(Some(row.nanoseconds)),
            time_text(Some(row.shortest)),
            time_text(Some(row.nanoseconds / case.n.max(1) as f64)),
            row.ratio.map_or_else(String::new, |ratio| ratio.text()),
            row.ratio
                .map_or_else(String::new, |ratio| format!("{:.2e}", ratio.p_value)),
            row.standing.to_string(),
        ]);
        if let Some(ratio) = row.ratio.filter(Ratio::drifts) {
            notes.push(format!(
                "{}: its ratio moved with the rounds (Spearman {:.2}): measure longer, or on a quieter machine",
                row.engine,
                ratio.drift.unwrap_or_default()
            ));
        }
    }
    Section {
        heading: format!(
            "{case}, h = {}, {} realisations",
            h_text(rows[0].h),
            rows[0].realisations
        ),
        sheet,
        notes,
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Standing::Baseline => "baseline",
            Standing::Faster => "faster",
            Standing::Slower => "slower",
            Standing::Open => "",
        })
    }
}
