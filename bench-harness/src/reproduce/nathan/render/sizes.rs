//! Average numbers of vertices of hulls in space, beside the exact expectations.

use crate::reproduce::nathan::records::Records;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::rows::SizeRow;
use crate::reproduce::theory::hull_size_in_space::expected;
use anyhow::Result;
use std::collections::BTreeMap;

/// An average this many standard errors off would be rare: once in 370 right ones.
const ALLOWED: f64 = 3.0;

/// The average of a cell beside its expectation.
struct Average {
    replicates: u64,
    mean: f64,
    deviation: f64,
    expected: f64,
}

impl Average {
    /// Of a histogram (vertices, replicates).
    fn of(histogram: &[(f64, f64)], expected: f64) -> Self {
        let total: f64 = histogram.iter().map(|(_, count)| count).sum();
        let mean = histogram.iter().map(|(v, count)| v * count).sum::<f64>() / total;
        let squares: f64 = histogram
            .iter()
            .map(|(v, count)| count * (v - mean).powi(2))
            .sum();
        Self {
            replicates: total as u64,
            mean,
            deviation: (squares / (total - 1.0)).sqrt(),
            expected,
        }
    }

    fn z(&self) -> f64 {
        (self.mean - self.expected) / (self.deviation / (self.replicates as f64).sqrt())
    }
}

/// Writes `sizes.md` and `sizes.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let mut groups: BTreeMap<(&str, usize), Vec<&SizeRow>> = BTreeMap::new();
    for row in &records.sizes {
        groups
            .entry((&row.distribution, row.n))
            .or_default()
            .push(row);
    }
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "replicates",
        "average vertices",
        "expected",
        "deviation of one",
        "z",
        "within 3",
    ]);
    for ((distribution, n), rows) in groups {
        let Some(expected) = expected(distribution, n) else {
            continue;
        };
        let histogram = rows
            .iter()
            .map(|row| (row.vertices as f64, row.replicates as f64));
        let average = Average::of(&histogram.collect::<Vec<_>>(), expected);
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            average.replicates.to_string(),
            format!("{:.3}", average.mean),
            format!("{:.3}", average.expected),
            format!("{:.3}", average.deviation),
            format!("{:.2}", average.z()),
            if average.z().abs() <= ALLOWED {
                "yes".to_owned()
            } else {
                "**no**".to_owned()
            },
        ]);
    }
    let text = format!(
        "Every hull is certified. *Expected* is the exact expectation for this n, by one integral over the planes that \
         carry facets; z is our average's distance from it in standard errors. It tests the generators and the hull \
         method at once: a right average is within {ALLOWED} nearly always.\n\n{}",
        sheet.markdown()
    );
    folder.markdown("sizes.md", "Sizes in space", &text)?;
    folder.csv("sizes.csv", &sheet.csv())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_histogram_has_its_moments() {
        let average = Average::of(&[(4.0, 2.0), (6.0, 2.0)], 4.0);
        assert!((average.mean - 5.0).abs() < 1e-15);
        assert!((average.deviation - (4.0_f64 / 3.0).sqrt()).abs() < 1e-15);
        assert!((average.z() - 3.0_f64.sqrt()).abs() < 1e-12);
    }
}
