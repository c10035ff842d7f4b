//! `fit`: the law of counts and of times, and its refusals.

use crate::made_up::MadeUp;
use bench_harness::analysis::fit::{Quantity, fit};
use bench_harness::stats::growth::Law;

const ALL: std::ops::RangeInclusive<usize> = 0..=usize::MAX;

fn plan(law: fn(f64) -> f64, seed: u64) -> MadeUp {
    MadeUp {
        sets: vec!["disc"],
        sizes: (8..=20).map(|power| 1 << power).collect(),
        engines: vec![("gs", 1.0)],
        twins: vec![],
        seeds: 8,
        law,
        ..MadeUp::new(seed)
    }
}

#[test]
fn laws_come_back_from_counts() {
    let plans = [
        (Law::N, plan(|n| 3.0 * n, 3)),
        (Law::NLogN, plan(|n| 2.0 * n * n.ln(), 3)),
        (Law::N3Over2, plan(|n| 0.5 * n.powf(1.5), 3)),
        (Law::N2, plan(|n| 0.1 * n * n, 3)),
    ];
    let quantity = Quantity::Counter("orient".into());
    for (law, plan) in plans {
        let fits = fit(&plan.run(), &quantity, &ALL);
        assert_eq!(fits.fitted.len(), 1);
        assert_eq!(
            fits.fitted[0].law(),
            Some(law),
            "{}",
            fits.fitted[0].verdict()
        );
        let text = fits.page().markdown();
        assert!(text.contains("slopes from size to size"), "{text}");
    }
}

#[test]
fn time_across_a_cache_border_declares_nothing_and_below_it_may() {
    let run = plan(|n| 0.1 * n * n, 3).run();
    let across = &fit(&run, &Quantity::Time, &ALL).fitted[0];
    assert_eq!(across.law(), None);
    // A mebibyte holds 65536 points of the plane.
    assert!(
        across.verdict().contains("L2 cache at n = 65536"),
        "{}",
        across.verdict()
    );
    let below = &fit(&run, &Quantity::Time, &(0..=65_536)).fitted[0];
    assert_eq!(below.law(), Some(Law::N2), "{}", below.verdict());
}

#[test]
fn a_short_range_says_nothing() {
    let quantity = Quantity::Counter("orient".into());
    let run = plan(|n| 2.0 * n * n.ln(), 3).run();
    let short = &fit(&run, &quantity, &(256..=4_096)).fitted[0];
    assert_eq!(short.law(), None);
    assert!(
        short.verdict().starts_with("not distinguishable"),
        "{}",
        short.verdict()
    );
}
