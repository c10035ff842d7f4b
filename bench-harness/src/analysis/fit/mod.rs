//! By which law a cost grows: counts first, for they are exact, and time as a second witness.
//!
//! Every engine on every point set is fitted by itself, each realisation an observation with its own h. A law is
//! declared as [`crate::stats::growth`] says, or none is.
//!
//! Time has borders: where the points no longer fit into a cache from L2 on, every call gets dearer, and a slope over
//! that border is the machine's and not the algorithm's. So no law is declared from time across one; the range can be
//! cut.

mod page;

use crate::records::manifest::Cache;
use crate::records::{Case, Run, rows::twin_of};
use crate::stats::growth::slopes::{self, LocalSlope};
use crate::stats::growth::{Choice, Law, Observation, Verdict, choose};
use crate::stats::line::{Line, fit_on_log};
use crate::stats::summary::median;
use point_sets::Spec;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// What is fitted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The time of a call.
    Time,
    /// What this counter counted.
    Counter(String),
}

/// One engine on one point set.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// The definition.
    pub definition: String,
    /// The point set.
    pub set: String,
    /// The engine.
    pub engine: String,
    /// Every realisation.
    pub data: Vec<Observation>,
    /// The candidates, and which law the data stand for.
    pub choice: Choice,
    /// The line through the logarithms.
    pub line: Option<Line>,
    /// How steep each law would be at the same sizes.
    pub expected: Vec<(Law, f64)>,
    /// The slopes from size to size.
    pub local: Vec<LocalSlope>,
    /// Cost a point = a + b ln n: its b is 0 for n, and above 0 for n log n.
    pub a_point: Option<Line>,
    /// The caches from L2 on whose capacity the points outgrow in this range, each with the n at which they do.
    pub borders: Vec<(Cache, f64)>,
}

impl Fitted {
    /// The law that is declared, if one is.
    pub fn law(&self) -> Option<Law> {
        match &self.choice.verdict {
            Verdict::Law { law, .. } if self.borders.is_empty() => Some(*law),
            _ => None,
        }
    }

    /// The verdict in words.
    pub fn verdict(&self) -> String {
        match self.borders.first() {
            None => self.choice.verdict.to_string(),
            Some((cache, n)) => format!(
                "not declared from time: the points outgrow the L{} cache at n = {n:.0}; the fit says {}",
                cache.level, self.choice.verdict
            ),
        }
    }
}

/// The answer.
#[derive(Clone, Debug)]
pub struct Fits {
    /// What was fitted.
    pub quantity: Quantity,
    /// Engine by engine.
    pub fitted: Vec<Fitted>,
}

/// Fits `quantity` of every engine on every point set, at the sizes in `sizes`.
pub fn fit(run: &Run, quantity: &Quantity, sizes: &RangeInclusive<usize>) -> Fits {
    let series = match quantity {
        Quantity::Time => times(run, sizes),
        Quantity::Counter(counter) => counts(run, counter, sizes),
    };
    let fitted = series
        .into_iter()
        .map(|((definition, set, engine), data)| {
            let borders = match quantity {
                Quantity::Time => borders(&run.manifest.caches, &set, &data),
                Quantity::Counter(_) => Vec::new(),
            };
            let a_point: Vec<(f64, f64)> = data.iter().map(|at| (at.n, at.cost / at.n)).collect();
            let expected = |law: Law| Some((law, slopes::slope_of(law, &data)?));
            Fitted {
                choice: choose(&data),
                line: slopes::overall(&data),
                expected: Law::ALL.into_iter().filter_map(expected).collect(),
                local: slopes::local(&data),
                a_point: fit_on_log(&a_point),
                borders,
                definition,
                set,
                engine,
                data,
            }
        })
        .collect();
    Fits {
        quantity: quantity.clone(),
        fitted,
    }
}

/// Definition, set and engine.
type Key = (String, String, String);

/// The median time of a call on every realisation.
fn times(run: &Run, sizes: &RangeInclusive<usize>) -> BTreeMap<Key, Vec<Observation>> {
    let mut series: BTreeMap<Key, Vec<Observation>> = BTreeMap::new();
    for case in run.cases() {
        for engine in run.timed(case) {
            let data = run.times(case, engine).iter().filter_map(|realisation| {
                let cost = median(&realisation.times());
                observation(run, case, realisation.seed, cost, sizes)
            });
            series.entry(key(case, engine)).or_default().extend(data);
        }
    }
    series.retain(|_, data| !data.is_empty());
    series
}

/// The count on every realisation. Zeros are left out: no law is zero.
fn counts(
    run: &Run,
    counter: &str,
    sizes: &RangeInclusive<usize>,
) -> BTreeMap<Key, Vec<Observation>> {
    let mut series: BTreeMap<Key, Vec<Observation>> = BTreeMap::new();
    for count in run.counts.iter().filter(|count| count.counter == counter) {
        let subject = &count.subject;
        if twin_of(&subject.engine).is_some() {
            continue;
        }
        let cost = count.value as f64;
        let data = observation(run, &subject.case, subject.seed, cost, sizes);
        if let Some(observation) = data {
            let key = key(&subject.case, &subject.engine);
            series.entry(key).or_default().push(observation);
        }
    }
    series
}

fn key(case: &Case, engine: &str) -> Key {
    (case.definition.clone(), case.set.clone(), engine.to_owned())
}

fn observation(
    run: &Run,
    case: &Case,
    seed: u64,
    cost: f64,
    sizes: &RangeInclusive<usize>,
) -> Option<Observation> {
    (sizes.contains(&case.n) && case.n > 0 && cost > 0.0).then(|| Observation {
        n: case.n as f64,
        h: run.h_of(case, seed).map(|h| h as f64),
        cost,
    })
}

/// From this level on a miss costs so much that a slope shows it.
const DEAR_LEVEL: u8 = 2;

/// The caches from L2 on that the coordinates outgrow between the least and the largest n, each with that n.
fn borders(caches: &[Cache], set: &str, data: &[Observation]) -> Vec<(Cache, f64)> {
    let sizes = data.iter().map(|place| place.n);
    let (least, most) = sizes.fold((f64::INFINITY, 0.0_f64), |(least, most), n| {
        (least.min(n), most.max(n))
    });
    let inside = |cache: &Cache| {
        let n = fills(cache, set);
        (least < n && n < most).then(|| (cache.clone(), n))
    };
    let dear = caches.iter().filter(|cache| cache.level >= DEAR_LEVEL);
    dear.filter_map(inside).collect()
}

/// How many points of `set` fill `cache`: 16 bytes a point of the plane, 24 of space.
pub(crate) fn fills(cache: &Cache, set: &str) -> f64 {
    let dimension = set.parse::<Spec>().map_or(2, |spec| spec.dimension());
    cache.bytes as f64 / (8.0 * dimension as f64)
}
