//! Rows that experiments in space leave behind, one CSV file a kind.

use serde::Serialize;

/// A point set that was used.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct SetRow {
    /// The experiment.
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) seed: u64,
    pub(crate) fingerprint: String,
    /// Vertices of the certified hull.
    pub(crate) vertices: usize,
    /// Facets of the certified hull, coplanar triangles merged.
    pub(crate) facets: usize,
    /// Methods whose result equals the certified hull.
    pub(crate) certified: usize,
    /// Methods tried.
    pub(crate) methods: usize,
}

/// What one method asked for on one set. Exact integers, equal on every machine.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct CountRow {
    pub(crate) stage: String,
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) method: String,
    /// Vertices of the hull.
    pub(crate) vertices: usize,
    /// Orientations of four points: which side of a plane a point is on.
    pub(crate) orientations: u64,
    /// Comparisons of two heights over a plane.
    pub(crate) heights: u64,
    /// Orientations of shadows.
    pub(crate) shadows: u64,
    /// Lexicographic comparisons.
    pub(crate) lexicographic: u64,
    /// Orientations and heights that the filter could not settle.
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

/// The CSV text of `rows`, and how many there are.
pub(crate) fn text<T: Serialize>(rows: &[T]) -> Result<(String, usize), csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| csv::Error::from(error.into_error()))?;
    Ok((String::from_utf8_lossy(&bytes).into_owned(), rows.len()))
}
