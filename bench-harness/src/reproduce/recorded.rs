//! From the records of a measured run to the rows that tables, figures and verdicts are computed from.
//!
//! A run names a realisation by its seed, a paper by its number; and a run has a row for each counter, a paper one for
//! each call. Rows come out in the order of the definitions, so that no order of measuring shows.

use super::rows::{CountRow, Dimension, FailureRow, Records, SetRow, SizeRow, TimeRow};
use super::sets::digest;
use crate::definition::Definition;
use crate::records::Run;
use crate::records::rows::{Cell, Outcome, Subject};
use std::collections::{BTreeMap, HashMap};

/// The definitions of this stage only certify: their cells become histograms of sizes.
const SIZES: &str = "sizes";

/// Adds the rows of `run`, which measured `definitions`.
pub(crate) fn add<Own>(run: &Run, definitions: &[Definition], records: &mut Records<Own>) {
    let places = Places::of(definitions);
    let mut tried: BTreeMap<Place, Vec<&Cell>> = BTreeMap::new();
    for cell in &run.cells {
        if let Some(place) = places.of_engine(&cell.subject) {
            tried.entry(place).or_default().push(cell);
        }
    }
    let mut measured: BTreeMap<usize, Vec<&Cell>> = BTreeMap::new();
    for (place, cells) in tried {
        let failed = cells.iter().filter(|c| c.outcome != Outcome::Certified);
        records
            .failures
            .extend(failed.map(|cell| failure(place, cell)));
        if stage(&cells[0].subject) == SIZES {
            measured.entry(place.case).or_default().extend(cells);
        } else {
            records.sets.push(set(place, &cells));
        }
    }
    records
        .sizes
        .extend(measured.into_values().flat_map(|cells| histogram(&cells)));
    records.counts.extend(counts(run, &places));
    records.times.extend(times(run, &places));
}

/// The number of a case in the definitions, and of a realisation in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    case: usize,
    replicate: u64,
    dimension: usize,
}

/// The place of every realisation of some definitions, by definition, set, size and seed.
struct Places(HashMap<(String, String, usize, u64), Place>);

impl Places {
    fn of(definitions: &[Definition]) -> Self {
        let mut places = HashMap::new();
        let mut cases = HashMap::new();
        for definition in definitions {
            for block in &definition.cells {
                let cells = block
                    .sets
                    .iter()
                    .flat_map(|set| block.n.iter().map(move |n| (set, *n)));
                for (set, n) in cells {
                    let key = (definition.id.clone(), set.to_string(), n);
                    let next = cases.len();
                    let case = *cases.entry(key.clone()).or_insert(next);
                    for replicate in 0..block.realisations {
                        let seed = point_sets::cell_seed(definition.seed, set, n, replicate);
                        let dimension = definition.problem.dimension();
                        let (id, set, n) = key.clone();
                        places.insert(
                            (id, set, n, seed),
                            Place {
                                case,
                                replicate,
                                dimension,
                            },
                        );
                    }
                }
            }
        }
        Self(places)
    }

    /// The place of `subject`, be it an engine's or a twin's.
    fn of_any(&self, subject: &Subject) -> Option<Place> {
        let case = &subject.case;
        let key = (
            case.definition.clone(),
            case.set.clone(),
            case.n,
            subject.seed,
        );
        self.0.get(&key).copied()
    }

    /// The place of `subject`; none for a twin, which is certified as the engine it is.
    fn of_engine(&self, subject: &Subject) -> Option<Place> {
        subject.twin_of().is_none().then(|| self.of_any(subject))?
    }
}

/// What a definition is for, which is how its name ends: "counts" of `gs-counts`.
fn stage(subject: &Subject) -> &str {
    let definition = &subject.case.definition;
    definition.rsplit('-').next().unwrap_or(definition)
}

fn failure(place: Place, cell: &Cell) -> FailureRow {
    let Subject { case, engine, .. } = &cell.subject;
    FailureRow {
        stage: stage(&cell.subject).to_owned(),
        distribution: case.set.clone(),
        n: case.n,
        replicate: place.replicate,
        method: engine.clone(),
        what: format!("{}: {}", cell.outcome, cell.finding),
    }
}

/// A realisation, and what became of the methods on it.
fn set(place: Place, cells: &[&Cell]) -> SetRow {
    let certified = || {
        cells
            .iter()
            .filter(|cell| cell.outcome == Outcome::Certified)
    };
    let Cell {
        subject,
        fingerprint,
        ..
    } = cells[0];
    SetRow {
        stage: stage(subject).to_owned(),
        distribution: subject.case.set.clone(),
        n: subject.case.n,
        replicate: place.replicate,
        seed: subject.seed,
        fingerprint: fingerprint.clone(),
        vertices: certified().find_map(|cell| cell.h).unwrap_or(0) as usize,
        facets: certified()
            .find_map(|cell| cell.facets)
            .map(|facets| facets as usize),
        certified: certified().count(),
        methods: cells.len(),
    }
}

/// The sizes of the hulls of one case.
fn histogram(cells: &[&Cell]) -> Vec<SizeRow> {
    let mut replicates: BTreeMap<u64, u64> = BTreeMap::new();
    for cell in cells
        .iter()
        .filter(|cell| cell.outcome == Outcome::Certified)
    {
        if let Some(vertices) = cell.h {
            *replicates.entry(vertices).or_default() += 1;
        }
    }
    let digest = digest(cells.iter().map(|cell| &cell.fingerprint));
    let row = |(vertices, replicates)| SizeRow {
        distribution: cells[0].subject.case.set.clone(),
        n: cells[0].subject.case.n,
        vertices: vertices as usize,
        replicates,
        digest: digest.clone(),
    };
    replicates.into_iter().map(row).collect()
}

/// A row for each counted call.
fn counts(run: &Run, places: &Places) -> Vec<CountRow> {
    let mut calls: BTreeMap<(Place, &Subject), BTreeMap<&str, u64>> = BTreeMap::new();
    for count in &run.counts {
        if let Some(place) = places.of_engine(&count.subject) {
            let counters = calls.entry((place, &count.subject)).or_default();
            counters.insert(&count.counter, count.value);
        }
    }
    let row = |((place, subject), counters): ((Place, &Subject), BTreeMap<&str, u64>)| {
        let dimension = if place.dimension == 2 {
            Dimension::Plane
        } else {
            Dimension::Space
        };
        CountRow {
            stage: stage(subject).to_owned(),
            distribution: subject.case.set.clone(),
            n: subject.case.n,
            replicate: place.replicate,
            method: subject.engine.clone(),
            vertices: run.h_of(&subject.case, subject.seed).unwrap_or(0) as usize,
            ..CountRow::of(dimension, &counters)
        }
    };
    calls.into_iter().map(row).collect()
}

/// A row for each sample.
fn times(run: &Run, places: &Places) -> Vec<TimeRow> {
    let placed = run
        .samples
        .iter()
        .filter_map(|sample| Some((places.of_any(&sample.subject)?, sample)));
    let mut samples: Vec<_> = placed.collect();
    samples.sort_by_key(|(place, sample)| (*place, sample.round));
    let row = |(place, sample): (Place, &crate::records::Sample)| TimeRow {
        distribution: sample.subject.case.set.clone(),
        n: sample.subject.case.n,
        realisation: place.replicate,
        round: sample.round,
        method: sample.subject.engine.clone(),
        calls: sample.inner.get(),
        nanoseconds: sample.nanoseconds,
    };
    samples.into_iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::rows::twin;
    use crate::records::{Case, Count, Manifest, Sample};
    use std::num::NonZeroU64;

    const TEXT: &str = r#"id = "x-counts"
group = "tests"
task = "hull2"
seed = 7
question = "Does it come out in order?"

[[cells]]
sets = ["disc", "circle"]
n = [10]
engines = ["gs", "eddy"]
measure = ["counts"]
realisations = 2

[[cells]]
sets = ["disc"]
n = [10]
engines = ["graham"]
measure = ["counts"]
realisations = 3
"#;

    fn definition(stage: &str) -> Definition {
        let text = TEXT.replace("x-counts", &format!("x-{stage}"));
        Definition::parse(&format!("x-{stage}.toml"), &text, &|_, _| Ok(())).expect("valid")
    }

    fn subject(definition: &Definition, set: &str, replicate: u64, engine: &str) -> Subject {
        let spec = set.parse().expect("a set");
        let case = Case {
            definition: definition.id.clone(),
            set: set.to_owned(),
            n: 10,
        };
        Subject {
            case,
            seed: point_sets::cell_seed(definition.seed, &spec, 10, replicate),
            engine: engine.to_owned(),
        }
    }

    fn cell(subject: Subject, outcome: Outcome, h: u64) -> Cell {
        Cell {
            subject,
            fingerprint: "ab".to_owned(),
            outcome,
            h: Some(h),
            facets: None,
            finding: "why".to_owned(),
        }
    }

    fn rows(
        definition: &Definition,
        cells: Vec<Cell>,
        (samples, counts): (Vec<Sample>, Vec<Count>),
    ) -> Records<()> {
        let run = Run::from_rows(Manifest::default(), cells, (samples, counts, Vec::new()));
        let mut records = Records::default();
        add(&run, std::slice::from_ref(definition), &mut records);
        records
    }

    #[test]
    fn cells_of_one_set_are_one_row_in_the_order_of_the_definition() {
        let definition = definition("counts");
        let of = |set, replicate, engine| subject(&definition, set, replicate, engine);
        let cells = vec![
            cell(of("circle", 0, "gs"), Outcome::Certified, 10),
            cell(of("disc", 1, "gs"), Outcome::Certified, 6),
            cell(of("disc", 0, "graham"), Outcome::Certified, 5),
            cell(of("disc", 0, "gs"), Outcome::Certified, 5),
            cell(of("disc", 0, "eddy"), Outcome::Wrong, 4),
            cell(of("disc", 2, "graham"), Outcome::Certified, 7),
        ];
        let records = rows(&definition, cells, (Vec::new(), Vec::new()));
        let row = |row: &SetRow| (row.distribution.clone(), row.replicate, row.certified);
        let found: Vec<_> = records.sets.iter().map(row).collect();
        let expected = [
            ("disc", 0, 2),
            ("disc", 1, 1),
            ("disc", 2, 1),
            ("circle", 0, 1),
        ];
        assert_eq!(found, expected.map(|(set, r, c)| (set.to_owned(), r, c)));
        assert_eq!(records.sets[0].vertices, 5);
        let failure = &records.failures[0];
        assert_eq!(
            (failure.method.as_str(), failure.what.as_str()),
            ("eddy", "wrong: why")
        );
        assert_eq!(records.failures.len(), 1);
    }

    #[test]
    fn sizes_become_a_histogram() {
        let definition = definition("sizes");
        let cells = [5, 5].iter().zip(0..).map(|(h, replicate)| {
            cell(
                subject(&definition, "disc", replicate, "gs"),
                Outcome::Certified,
                *h,
            )
        });
        let records = rows(&definition, cells.collect(), (Vec::new(), Vec::new()));
        let [row] = &records.sizes[..] else {
            panic!("{:?}", records.sizes)
        };
        assert_eq!((row.vertices, row.replicates), (5, 2));
        assert!(records.sets.is_empty());
    }

    #[test]
    fn counters_of_a_call_are_one_row_and_a_twin_is_timed() {
        let definition = definition("times");
        let gs = || subject(&definition, "disc", 1, "gs");
        let count = |counter: &str, value| Count {
            subject: gs(),
            counter: counter.to_owned(),
            value,
        };
        let sample = |subject, round| Sample {
            subject,
            round,
            inner: NonZeroU64::new(4).expect("four"),
            nanoseconds: 8,
        };
        let samples = vec![sample(gs(), 1), sample(gs().twin(), 0)];
        let counts = vec![count("orientations", 3), count("along", 2)];
        let cells = vec![cell(gs(), Outcome::Certified, 6)];
        let records = rows(&definition, cells, (samples, counts));
        let [row] = &records.counts[..] else {
            panic!("{:?}", records.counts)
        };
        assert_eq!((row.replicate, row.vertices, row.questions()), (1, 6, 5));
        let names: Vec<&str> = records
            .times
            .iter()
            .map(|row| row.method.as_str())
            .collect();
        assert_eq!(names, [twin("gs").as_str(), "gs"]);
        assert!(records.times.iter().all(|row| row.realisation == 1));
    }
}
