//! The stops of a run: cells by realisation, in the order in which they are visited.

use crate::definition::{Block, Definition, Measure};
use crate::records::{Case, rows};

/// One realisation of one cell.
#[derive(Clone, Debug)]
pub(crate) struct Stop<'a> {
    pub(crate) definition: &'a Definition,
    pub(crate) block: &'a Block,
    pub(crate) spec: &'a point_sets::Spec,
    pub(crate) n: usize,
    /// Its number, from 0.
    pub(crate) realisation: u64,
    /// The engines that take part.
    pub(crate) engines: Vec<String>,
}

impl Stop<'_> {
    pub(crate) fn case(&self) -> Case {
        Case {
            definition: self.definition.id.clone(),
            set: self.spec.to_string(),
            n: self.n,
        }
    }

    /// The seed of the realisation.
    pub(crate) fn seed(&self) -> u64 {
        point_sets::cell_seed(self.definition.seed, self.spec, self.n, self.realisation)
    }

    /// Whether nothing else may run meanwhile.
    pub(crate) fn is_timed(&self) -> bool {
        self.block.measure.contains(&Measure::Time)
    }

    pub(crate) fn name(&self) -> String {
        format!("{}, realisation {}", self.case(), self.realisation)
    }
}

/// What of the definitions is wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Selection {
    /// Only these engines; none stands for all.
    pub(crate) engines: Vec<String>,
    /// Engines beside those of the definition.
    pub(crate) guests: Vec<String>,
    pub(crate) at_most: Option<usize>,
    pub(crate) realisations: Option<u64>,
}

impl Selection {
    fn engines(&self, block: &Block) -> Vec<String> {
        let wanted = |engine: &&String| self.engines.is_empty() || self.engines.contains(engine);
        let twin = block.twin.iter().filter(wanted);
        let twin = twin.map(|engine| rows::twin(engine));
        let engines = block.engines.iter().filter(wanted).cloned();
        engines
            .chain(twin)
            .chain(self.guests.iter().cloned())
            .collect()
    }
}

/// The stops of `definitions`: realisation 0 of every cell by size, then 1, and so on.
pub(crate) fn stops<'a>(definitions: &'a [Definition], selection: &Selection) -> Vec<Stop<'a>> {
    let mut stops = Vec::new();
    for definition in definitions {
        for block in &definition.cells {
            let engines = selection.engines(block);
            let sizes = block
                .n
                .iter()
                .filter(|&&n| selection.at_most.is_none_or(|most| n <= most));
            let realisations = selection
                .realisations
                .map_or(block.realisations, |most| most.min(block.realisations));
            for (&n, spec) in sizes.flat_map(|n| block.sets.iter().map(move |spec| (n, spec))) {
                for realisation in 0..realisations {
                    let engines = engines.clone();
                    stops.push(Stop {
                        definition,
                        block,
                        spec,
                        n,
                        realisation,
                        engines,
                    });
                }
            }
        }
    }
    stops.retain(|stop| !stop.engines.is_empty());
    stops.sort_by_key(|stop| (stop.realisation, stop.n));
    stops
}
