//! The definition of the experiment, read from `data/definitions/`.

use crate::reproduce::data::{in_checkout_or, product};
use anyhow::{Context, Result, ensure};
use serde::Deserialize;

/// Where the paper's files lie below `data/definitions` and `data/published`.
pub(crate) const PAPER: &str = "day-1990";

/// What is run: which sets, which formats and variants, how often.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Definition {
    /// The paper's short name.
    pub(crate) paper: String,
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
    /// The whole call counted.
    pub(crate) counts: Vec<Cells>,
    /// The whole call timed.
    pub(crate) times: Vec<Times>,
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

/// A block of cells.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cells {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
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

/// A block of cells of which the whole call is timed. A cell is in one block only.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Times {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    /// Batches of sets.
    pub(crate) realisations: u64,
    /// A batch holds different sets of at least so many points in all.
    pub(crate) points_a_batch: u64,
    pub(crate) rounds: u32,
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

impl Cells {
    /// Each set of the block: distribution, size, replicate.
    pub(crate) fn sets(&self) -> Vec<(String, usize, u64)> {
        let cells = product(&self.distributions, &self.n).into_iter();
        let sets = cells.flat_map(|(distribution, n)| {
            (0..self.replicates).map(move |replicate| (distribution.clone(), n, replicate))
        });
        sets.collect()
    }
}

impl Definition {
    /// The bits of the format called `name`, and who computes in it.
    pub(crate) fn format(&self, name: &str) -> Option<&Format> {
        let formats = self.precision.formats.iter();
        formats.into_iter().find(|format| format.name == name)
    }

    /// The reference run or the quick one: the checkout's file if the program runs in one, else the copy
    /// built into the program.
    pub(crate) fn load(quick: bool) -> Result<Self> {
        let (name, built_in) = if quick {
            (
                "quick.toml",
                include_str!("../../../../data/definitions/day-1990/quick.toml"),
            )
        } else {
            (
                "full.toml",
                include_str!("../../../../data/definitions/day-1990/full.toml"),
            )
        };
        let text = in_checkout_or(&format!("data/definitions/{PAPER}/{name}"), built_in)?;
        let definition: Self = toml::from_str(&text).with_context(|| format!("in {name}"))?;
        ensure!(
            definition.paper == PAPER,
            "{name} is for the paper {:?}",
            definition.paper
        );
        Ok(definition)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::day::formats;
    use crate::reproduce::day::sets::generate;
    use crate::reproduce::day::variants;

    #[test]
    fn both_definitions_name_known_things_only() {
        for quick in [false, true] {
            let definition = Definition::load(quick).expect("valid");
            let precision = &definition.precision;
            for cells in &precision.cells {
                for name in &cells.formats {
                    let known = precision.formats.iter().any(|format| format.name == *name);
                    assert!(known && formats::find(name).is_ok(), "no format {name:?}");
                }
                assert!(cells.powers[0] <= cells.powers[1]);
            }
            let at_power = definition.degenerate.formats.iter();
            for format in at_power.chain(&definition.checks.formats) {
                assert!(formats::find(&format.name).is_ok(), "{format:?}");
            }
            assert!(formats::find(&definition.dummies.format).is_ok());
            for name in definition.merges.iter().flat_map(|block| &block.variants) {
                assert!(variants::find(name).is_ok(), "no variant {name:?}");
            }
            let cells = definition.counts.iter().chain(&definition.listing);
            let cells = cells.chain(&definition.parallel);
            let distributions = cells.flat_map(|block| &block.distributions);
            let distributions = distributions
                .chain(precision.cells.iter().map(|cells| &cells.distribution))
                .chain(definition.merges.iter().flat_map(|b| &b.distributions))
                .chain(definition.times.iter().flat_map(|b| &b.distributions))
                .chain(definition.degenerate.sets.iter().map(|k| &k.distribution))
                .chain(&definition.bases.distributions)
                .chain([
                    &definition.speed.distribution,
                    &definition.dummies.distribution,
                ])
                .chain([&definition.checks.distribution]);
            for distribution in distributions {
                assert!(generate(1, distribution, 66, 0).is_ok(), "{distribution:?}");
            }
        }
    }

    #[test]
    fn parts_of_one_level_have_one_size() {
        for quick in [false, true] {
            let bases = Definition::load(quick).expect("valid").bases;
            assert!(bases.n.is_power_of_two());
            assert!(bases.sizes.iter().all(|size| size.is_power_of_two()));
            let dummies = Definition::load(quick).expect("valid").dummies;
            assert!(dummies.n.iter().all(|n| n % 4 != 0));
        }
    }

    #[test]
    fn an_unknown_key_is_an_error() {
        let text = include_str!("../../../../data/definitions/day-1990/quick.toml");
        assert!(toml::from_str::<Definition>(&format!("sedd = 3\n{text}")).is_err());
    }
}
