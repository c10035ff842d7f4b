//! What the studies of this paper run on, read from its `studies.toml`.

use crate::reproduce::data::Cells;
use serde::Deserialize;

/// What is run: which sets, which formats and variants, how often.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Studies {
    /// The seed from which every set's seed is derived.
    pub(crate) seed: u64,
    /// What a reader should know of this choice.
    pub(crate) analysis: String,
    /// Day's cotangents in several formats.
    pub(crate) precision: Precision,
    /// The formats timed.
    pub(crate) speed: Speed,
    /// Merges counted.
    pub(crate) merges: Vec<Merges>,
    /// Sets that are in no catalogue, of which the whole call is counted.
    pub(crate) turned: Vec<Cells>,
    /// Degenerate sets.
    pub(crate) degenerate: Degenerate,
    /// Sizes at which the recursion could stop.
    pub(crate) bases: Bases,
    /// Sizes that are no multiple of four.
    pub(crate) dummies: Dummies,
    /// Faces listed by a spiral.
    pub(crate) listing: Vec<Cells>,
    /// Hulls given to the paper's own check.
    pub(crate) checks: Checks,
    /// The halves conquered side by side.
    pub(crate) parallel: Vec<Cells>,
}

/// Number formats, and the cells of the study.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Precision {
    pub(crate) formats: Vec<Format>,
    pub(crate) cells: Vec<PrecisionCells>,
}

/// A number format.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Format {
    pub(crate) name: String,
    /// Bits of the significand that are sure: of six hexadecimal digits, 21.
    pub(crate) bits: u32,
    /// Who computes.
    pub(crate) arithmetic: Arithmetic,
}

/// Who computes in a format.
#[derive(Clone, Copy, Debug, Deserialize, serde::Serialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Arithmetic {
    /// The processor.
    Hardware,
    /// A program, bit for bit.
    Software,
}

/// A block of cells: a size in several ranges and at several offsets. Coordinates are range times those of the
/// distribution, plus the offset.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PrecisionCells {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) ranges: Vec<f64>,
    pub(crate) offsets: Vec<f64>,
    pub(crate) formats: Vec<String>,
    /// eps2 runs over the powers of ten from the first to the last of these.
    pub(crate) powers: [i32; 2],
    pub(crate) sets: u64,
}

/// The formats timed on the same sets.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Speed {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// The power of ten of eps2.
    pub(crate) power: i32,
    pub(crate) sets: u64,
    pub(crate) rounds: u32,
}

/// A block of cells whose merges are counted.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Merges {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) variants: Vec<String>,
    pub(crate) replicates: u64,
}

/// Where the recursion could stop.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Bases {
    pub(crate) distributions: Vec<String>,
    /// A power of two, so that all parts of one level have one size.
    pub(crate) n: usize,
    /// The sizes, powers of two.
    pub(crate) sizes: Vec<usize>,
    pub(crate) replicates: u64,
}

/// Sets to which up to three points inside must be added.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Dummies {
    pub(crate) distribution: String,
    pub(crate) n: Vec<usize>,
    pub(crate) format: String,
    /// The power of ten of eps2.
    pub(crate) power: i32,
    pub(crate) sets: u64,
}

/// Hulls, right and wrong, given to the paper's own check.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Checks {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// What makes the hulls, and then checks them.
    pub(crate) formats: Vec<AtPower>,
    pub(crate) sets: u64,
}

/// The battery of degenerate sets, and sets in general position beside them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Degenerate {
    pub(crate) formats: Vec<AtPower>,
    pub(crate) general: Vec<Sized>,
    pub(crate) sets: Vec<Kind>,
    pub(crate) replicates: u64,
}

/// A format at one eps2.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AtPower {
    pub(crate) name: String,
    /// The power of ten of eps2.
    pub(crate) power: i32,
}

/// A distribution and a size.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sized {
    pub(crate) distribution: String,
    pub(crate) n: usize,
}

/// A degenerate set and what is degenerate about it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Kind {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) what: String,
}

impl Studies {
    /// The bits of the format called `name`, and who computes in it.
    pub(crate) fn format(&self, name: &str) -> Option<&Format> {
        let formats = self.precision.formats.iter();
        formats.into_iter().find(|format| format.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::data::{EXTENTS, studies};
    use crate::reproduce::day::SLUG;
    use crate::reproduce::day::formats;
    use crate::reproduce::day::sets::generate;
    use crate::reproduce::day::variants;

    #[test]
    fn both_extents_name_known_things_only() {
        for extent in EXTENTS {
            let studies: Studies = studies(SLUG, extent).expect("valid");
            let precision = &studies.precision;
            for cells in &precision.cells {
                for name in &cells.formats {
                    let known = precision.formats.iter().any(|format| format.name == *name);
                    assert!(known && formats::find(name).is_ok(), "no format {name:?}");
                }
                assert!(cells.powers[0] <= cells.powers[1]);
            }
            let at_power = studies.degenerate.formats.iter();
            for format in at_power.chain(&studies.checks.formats) {
                assert!(formats::find(&format.name).is_ok(), "{format:?}");
            }
            assert!(formats::find(&studies.dummies.format).is_ok());
            for name in studies.merges.iter().flat_map(|block| &block.variants) {
                assert!(variants::find(name).is_ok(), "no variant {name:?}");
            }
            let cells = studies.turned.iter().chain(&studies.listing);
            let cells = cells.chain(&studies.parallel);
            let distributions = cells.flat_map(|block| &block.distributions);
            let distributions = distributions
                .chain(precision.cells.iter().map(|cells| &cells.distribution))
                .chain(studies.merges.iter().flat_map(|b| &b.distributions))
                .chain(studies.degenerate.sets.iter().map(|k| &k.distribution))
                .chain(&studies.bases.distributions)
                .chain([&studies.speed.distribution, &studies.dummies.distribution])
                .chain([&studies.checks.distribution]);
            for distribution in distributions {
                assert!(generate(1, distribution, 66, 0).is_ok(), "{distribution:?}");
            }
        }
    }

    #[test]
    fn parts_of_one_level_have_one_size() {
        for extent in EXTENTS {
            let Studies { bases, dummies, .. } = studies(SLUG, extent).expect("valid");
            assert!(bases.n.is_power_of_two());
            assert!(bases.sizes.iter().all(|size| size.is_power_of_two()));
            assert!(dummies.n.iter().all(|n| n % 4 != 0));
        }
    }
}
