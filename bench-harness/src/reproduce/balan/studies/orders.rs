//! Insertion in the order given and in random orders (B-5).
//!
//! The facets made and dropped are those of `incremental-3d`; with a conflict graph they would be the same, but the
//! graph of the bad order has n³/16 arcs in all.

use crate::reproduce::balan::definition::{Orders, Studies};
use crate::reproduce::balan::records::Records;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::{CountRow, FailureRow, SetRow};
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify_results;
use crate::reproduce::space::count::row;
use anyhow::Result;
use geometry_core::{Counted, Exact, Points, Tally};
use incremental::{Order, incremental_3d_in};

/// The name of this study in the records.
const STAGE: &str = "orders";

/// The methods' names in the records.
pub(crate) const AS_GIVEN: &str = "incremental-3d, order as given";
/// See [`AS_GIVEN`].
pub(crate) const SHUFFLED: &str = "incremental-3d, random order";

/// Inserts the points of every size in every order.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let Orders {
        distribution,
        n,
        replicates,
    } = &studies.orders;
    let progress = Progress::start(STAGE, n.len());
    let mut sizes = n.clone();
    // The longest first, so that two cores end together.
    sizes.sort_unstable_by(|a, b| b.cmp(a));
    let results = parallel::map(&sizes, |&n| {
        let set = PointSet3::generate(studies.seed, distribution, n, 0)?;
        let seeds = 0..*replicates;
        let shuffled = seeds.map(|seed| (SHUFFLED, Order::Shuffled { seed }));
        let orders = [(AS_GIVEN, Order::AsGiven)].into_iter().chain(shuffled);
        let result = insert(&set, orders)?;
        progress.finished(&format!("{distribution} {n}"));
        Ok(result)
    })?;
    for (set, failures, counts) in results {
        records.sets.push(set);
        records.failures.extend(failures);
        records.counts.extend(counts);
    }
    Ok(())
}

/// One set inserted in several orders, each result certified.
fn insert(
    set: &PointSet3,
    orders: impl Iterator<Item = (&'static str, Order)>,
) -> Result<(SetRow, Vec<FailureRow>, Vec<CountRow>)> {
    let points = Points::new(&set.points)?;
    let mut results = Vec::new();
    let mut counts = Vec::new();
    for (replicate, (name, order)) in (0_u64..).zip(orders) {
        let kernel = Counted::new(Exact);
        let mut tally = Tally::default();
        let result = incremental_3d_in(points, order, &kernel, &mut tally);
        if let Ok(hull) = &result {
            counts.push(CountRow {
                // The order as given is number 0, and so is the first random one.
                replicate: replicate.saturating_sub(1),
                ..row(STAGE, set, name, hull, &kernel.counts(), &tally)
            });
        }
        results.push((name.to_owned(), result));
    }
    let certified = certify_results(STAGE, set, results);
    counts.retain(|row| {
        !certified
            .failures
            .iter()
            .any(|failure| failure.method == row.method)
    });
    Ok((certified.set, certified.failures, counts))
}
