//! What a run leaves behind of a paper: plain rows, one CSV file a kind. Tables, figures and verdicts are computed
//! from these alone.
//!
//! Sets, sizes, counts, times and failures are those of every paper; each adds the tables of its own studies.

use anyhow::Result;
use serde::Serialize;
use std::collections::BTreeMap;

/// Everything recorded of one paper in one run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records<Own> {
    /// Every set that was used. Sets of which only the size was taken are in `sizes`, by digest.
    pub(crate) sets: Vec<SetRow>,
    /// Numbers of vertices, as histograms.
    pub(crate) sizes: Vec<SizeRow>,
    /// Questions asked, and what was made.
    pub(crate) counts: Vec<CountRow>,
    /// Time samples.
    pub(crate) times: Vec<TimeRow>,
    /// Results without a certificate.
    pub(crate) failures: Vec<FailureRow>,
    /// The tables of the paper's own studies.
    pub(crate) own: Own,
}

/// The rows of studies alone.
impl<Own> From<Own> for Records<Own> {
    fn from(own: Own) -> Self {
        Self {
            sets: Vec::new(),
            sizes: Vec::new(),
            counts: Vec::new(),
            times: Vec::new(),
            failures: Vec::new(),
            own,
        }
    }
}

/// The tables of a paper's own studies.
pub(crate) trait Tables: Default {
    /// Adds each table to the files of the report.
    fn write(&self, files: &mut Files) -> Result<()>;
}

/// CSV files by name, empty ones left out.
#[derive(Clone, Debug, Default)]
pub(crate) struct Files(Vec<(&'static str, String)>);

impl Files {
    /// Adds a file of `rows`, unless there are none.
    pub(crate) fn add<R: Serialize>(&mut self, name: &'static str, rows: &[R]) -> Result<()> {
        if rows.is_empty() {
            return Ok(());
        }
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in rows {
            writer.serialize(row)?;
        }
        let text = String::from_utf8(writer.into_inner()?)?;
        self.0.push((name, text));
        Ok(())
    }
}

impl<Own> Records<Own> {
    /// Whether `method` failed to be certified on any set of the cell.
    pub(crate) fn failed(&self, distribution: &str, n: usize, method: &str) -> bool {
        let is_it = |row: &FailureRow| {
            row.distribution == distribution && row.n == n && row.method == method
        };
        self.failures.iter().any(is_it)
    }
}

impl<Own: Tables> Records<Own> {
    /// Every table that has rows: its name and its text.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, String)>> {
        let mut files = Files::default();
        files.add("sets", &self.sets)?;
        files.add("sizes", &self.sizes)?;
        files.add("counts", &self.counts)?;
        files.add("times", &self.times)?;
        files.add("failures", &self.failures)?;
        self.own.write(&mut files)?;
        Ok(files.0)
    }
}

/// A point set that was used, or a batch of them.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct SetRow {
    /// What it was used for.
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// Of a batch, the seed of its first set, from which those of the others follow.
    pub(crate) seed: u64,
    pub(crate) fingerprint: String,
    /// Vertices of the certified hull.
    pub(crate) vertices: usize,
    /// Facets of the certified hull, coplanar triangles merged; none in the plane.
    pub(crate) facets: Option<usize>,
    /// Methods whose result is certified.
    pub(crate) certified: usize,
    /// Methods tried.
    pub(crate) methods: usize,
}

/// How many replicates of a cell have a hull of so many vertices.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct SizeRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) vertices: usize,
    pub(crate) replicates: u64,
    /// SHA-256, shortened, over the fingerprints of all replicates of the cell in order.
    pub(crate) digest: String,
}

/// What one method asked for and made on one set. Exact integers, equal on every machine.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct CountRow {
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) method: String,
    /// Vertices of the hull.
    pub(crate) vertices: usize,
    /// Orientations: of three points in the plane, of four in space.
    pub(crate) orientations: u64,
    /// Comparisons of two distances from a line.
    pub(crate) distances: u64,
    /// Comparisons along a line.
    pub(crate) along: u64,
    /// Comparisons of two angles.
    pub(crate) angles: u64,
    /// Comparisons of two heights over a plane.
    pub(crate) heights: u64,
    /// Orientations of shadows.
    pub(crate) shadows: u64,
    /// Lexicographic comparisons.
    pub(crate) lexicographic: u64,
    /// Orientations, distances and heights that the filter could not settle.
    pub(crate) beyond_filter: u64,
    /// Points looked at.
    pub(crate) visits: u64,
    /// Facets made.
    pub(crate) facets: u64,
    /// Facets dropped.
    pub(crate) drops: u64,
    /// Candidates examined.
    pub(crate) candidates: u64,
    /// Supporting lines or planes found.
    pub(crate) bridges: u64,
    /// Merges.
    pub(crate) merges: u64,
    /// Points inserted.
    pub(crate) inserts: u64,
    /// Most records of working storage.
    pub(crate) storage: u64,
}

/// Which coordinates a method's main question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimension {
    Plane,
    Space,
}

impl CountRow {
    /// The row with these counters; what is not among them is 0. The subject is left to be named.
    pub(crate) fn of(dimension: Dimension, counters: &BTreeMap<&str, u64>) -> Self {
        let of = |name| counters.get(name).copied().unwrap_or(0);
        let (orientations, hard, other_hard) = match dimension {
            Dimension::Plane => (
                "orientations",
                "orientations-beyond-filter",
                "distances-beyond-filter",
            ),
            Dimension::Space => (
                "orientations-in-space",
                "orientations-in-space-beyond-filter",
                "heights-beyond-filter",
            ),
        };
        Self {
            orientations: of(orientations),
            distances: of("distances"),
            along: of("along"),
            angles: of("angles"),
            heights: of("heights"),
            shadows: of("shadows"),
            lexicographic: of("lexicographic"),
            beyond_filter: of(hard) + of(other_hard),
            visits: of("visits"),
            facets: of("facets"),
            drops: of("drops"),
            candidates: of("candidates"),
            bridges: of("bridges"),
            merges: of("merges"),
            inserts: of("inserts"),
            storage: of("storage"),
            ..Self::default()
        }
    }

    /// All questions of every kind.
    pub(crate) fn questions(&self) -> u64 {
        let plane = self.distances + self.along + self.angles;
        self.orientations + plane + self.heights + self.shadows + self.lexicographic
    }
}

/// One time sample: `calls` calls in a row on the sets of one batch.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct TimeRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// Number of the batch of sets.
    pub(crate) realisation: u64,
    pub(crate) round: u32,
    pub(crate) method: String,
    pub(crate) calls: u64,
    pub(crate) nanoseconds: u64,
}

impl TimeRow {
    /// Nanoseconds of one call.
    pub(crate) fn per_call(&self) -> f64 {
        self.nanoseconds as f64 / self.calls as f64
    }
}

/// A result that was not certified, and therefore neither counted nor timed.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FailureRow {
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) method: String,
    pub(crate) what: String,
}
