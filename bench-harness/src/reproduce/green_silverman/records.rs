//! What the experiments leave behind: plain rows, one CSV file a kind. Tables, figures and verdicts are
//! computed from these alone.

use serde::Serialize;

/// Everything recorded in one run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Every set that was counted, timed or peeled.
    pub(crate) sets: Vec<SetRow>,
    /// Numbers of vertices, as histograms.
    pub(crate) sizes: Vec<SizeRow>,
    /// Questions asked.
    pub(crate) counts: Vec<CountRow>,
    /// Time samples.
    pub(crate) times: Vec<TimeRow>,
    /// Complete peelings.
    pub(crate) peels: Vec<PeelRow>,
    /// Peelings and hulls with a tolerance.
    pub(crate) tolerance: Vec<ToleranceRow>,
    /// Peelings of the exact lattices under both conventions.
    pub(crate) rings: Vec<RingRow>,
    /// Results without a certificate.
    pub(crate) failures: Vec<FailureRow>,
}

/// A point set that was used.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SetRow {
    /// "counts", "times" or "peels".
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) seed: u64,
    pub(crate) fingerprint: String,
    /// Vertices of the certified hull, all boundary points counted.
    pub(crate) vertices: usize,
    /// Methods whose result equals the certified hull.
    pub(crate) certified: usize,
    /// Methods tried.
    pub(crate) methods: usize,
}

/// How many replicates of a cell have a hull of so many vertices.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SizeRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) vertices: usize,
    pub(crate) replicates: u64,
    /// SHA-256, shortened, over the fingerprints of all replicates of the cell in order.
    pub(crate) digest: String,
}

/// What one method asked for on one set. Exact integers, equal on every machine.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct CountRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) method: String,
    /// Orientations of three points: the paper's area evaluations.
    pub(crate) orientations: u64,
    /// Comparisons of two distances from a line (areas already evaluated, in the paper).
    pub(crate) distances: u64,
    /// Comparisons along a line.
    pub(crate) along: u64,
    /// Lexicographic comparisons.
    pub(crate) lexicographic: u64,
    /// Comparisons of two angles.
    pub(crate) angles: u64,
    /// Orientations and distances that the filter could not settle.
    pub(crate) beyond_filter: u64,
    /// Points looked at.
    pub(crate) visits: u64,
    /// Most records of working storage.
    pub(crate) storage: u64,
}

impl CountRow {
    /// All questions of every kind.
    pub(crate) fn questions(&self) -> u64 {
        self.orientations + self.distances + self.along + self.lexicographic + self.angles
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

/// One complete peeling of one set by Green and Silverman's method with exact answers, certified.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct PeelRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) layers: usize,
    /// Points on the largest peel.
    pub(crate) largest: usize,
    /// Sum over the peels of the points left before each.
    pub(crate) remaining: u64,
    pub(crate) visits: u64,
    pub(crate) orientations: u64,
    pub(crate) questions: u64,
    /// High-water mark of the stack, the paper's m.
    pub(crate) storage: u64,
}

/// The sweep of the tolerance over one set in one format.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ToleranceRow {
    /// "random"; "lattice", turned about the origin; "lattice-fitted", turned and fitted into the unit square;
    /// "lattice-eddy", the first hull of a turned lattice by Eddy's method.
    pub(crate) data: String,
    pub(crate) format: String,
    /// Decimals of the coordinates; empty for all that a double holds.
    pub(crate) decimals: Option<u32>,
    pub(crate) replicate: u64,
    pub(crate) fingerprint: String,
    /// One letter for each ε = 1e-1, 1e-2, …: `r` right, `w` wrong, `c` stopped by a contradiction.
    pub(crate) outcomes: String,
}

/// The rings of a lattice, peeled with exact answers.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct RingRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// "all" or "extreme".
    pub(crate) boundary: String,
    pub(crate) method: String,
    /// Points on the rings from the outside in, separated by spaces.
    pub(crate) rings: String,
    pub(crate) certified: bool,
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

impl Records {
    /// Whether `method` failed to be certified on any set of the cell.
    pub(crate) fn failed(&self, distribution: &str, n: usize, method: &str) -> bool {
        self.failures
            .iter()
            .any(|row| row.distribution == distribution && row.n == n && row.method == method)
    }

    /// Every file of records: its name, its text without the head, and how many rows it has.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, String, usize)>, csv::Error> {
        Ok(vec![
            ("sets.csv", text(&self.sets)?, self.sets.len()),
            ("sizes.csv", text(&self.sizes)?, self.sizes.len()),
            ("counts.csv", text(&self.counts)?, self.counts.len()),
            ("times.csv", text(&self.times)?, self.times.len()),
            ("peels.csv", text(&self.peels)?, self.peels.len()),
            (
                "tolerance.csv",
                text(&self.tolerance)?,
                self.tolerance.len(),
            ),
            ("rings.csv", text(&self.rings)?, self.rings.len()),
            ("failures.csv", text(&self.failures)?, self.failures.len()),
        ])
    }
}

fn text<T: Serialize>(rows: &[T]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
