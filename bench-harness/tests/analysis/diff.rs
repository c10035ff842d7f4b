//! `diff`: nothing about nothing, and the one method that got slower.

use crate::made_up::MadeUp;
use bench_harness::analysis::diff::{Change, diff};
use bench_harness::records::Outcome;
use std::collections::BTreeSet;

#[test]
fn a_run_against_itself_says_nothing() {
    let run = MadeUp::new(1).run();
    let diff = diff(&run, &run);
    assert_eq!(diff.rows.len(), 24);
    assert!(diff.rows.iter().all(|row| row.change == Change::None));
    assert!(diff.counts.is_empty() && diff.lost.is_empty() && diff.notes.is_empty());
    assert!(diff.regression().is_none());
}

#[test]
fn the_method_that_is_slower_by_thirty_percent_is_named_and_no_other() {
    for seed in 0..8 {
        let old = MadeUp::new(seed);
        let mut new = MadeUp::new(1_000 + seed);
        new.engines[1].1 *= 1.3;
        let found = diff(&old.run(), &new.run());
        let names: BTreeSet<&str> = found
            .rows
            .iter()
            .filter(|row| row.change != Change::None)
            .map(|row| row.engine.as_str())
            .collect();
        assert_eq!(names, BTreeSet::from(["eddy"]), "seed {seed}");
        // A cell that the machine disturbed often may stay open.
        let cells = found.changed(Change::Slower).count();
        assert!(cells >= 5, "seed {seed}: {cells} of 6");
        let text = found.regression().expect("a regression");
        assert!(text.contains("cells are slower (eddy; "), "{text}");
        assert!(found.page().markdown().contains("| eddy"));
    }
}

#[test]
fn a_method_that_is_faster_is_no_regression() {
    let mut new = MadeUp::new(8);
    new.engines[2].1 *= 0.7;
    let found = diff(&MadeUp::new(7).run(), &new.run());
    assert!(
        found
            .changed(Change::Faster)
            .all(|row| row.engine == "graham")
    );
    assert_eq!(found.changed(Change::Faster).count(), 6);
    assert!(found.regression().is_none());
}

#[test]
fn two_runs_of_the_same_programs_rarely_differ() {
    const PAIRS: u64 = 100;
    let noisy = |seed: u64| MadeUp {
        sizes: vec![1_000],
        noise: 0.05,
        rounds: 5,
        seeds: 3,
        ..MadeUp::new(seed)
    };
    let alarms = (0..PAIRS).filter(|pair| {
        let found = diff(&noisy(2 * pair).run(), &noisy(2 * pair + 1).run());
        found.rows.iter().any(|row| row.change != Change::None)
    });
    let alarms = alarms.count();
    assert!(alarms <= 5, "{alarms} of {PAIRS} pairs of runs differ");
}

#[test]
fn a_machine_that_is_slower_altogether_is_suspected() {
    let mut new = MadeUp::new(4);
    for engine in &mut new.engines {
        engine.1 *= 1.2;
    }
    let found = diff(&MadeUp::new(3).run(), &new.run());
    assert!(
        found.notes[0].contains("it may be the machine"),
        "{:?}",
        found.notes
    );
}

#[test]
fn a_difference_inside_the_band_is_not_claimed() {
    // Twins that lie in memory luckily or not by 5 % make a band that holds 4 %.
    let scattered = |seed: u64| MadeUp {
        placement: 0.05,
        ..MadeUp::new(seed)
    };
    let (old, mut new) = (scattered(1), scattered(2));
    new.engines[1].1 *= 1.04;
    let found = diff(&old.run(), &new.run());
    assert_eq!(found.changed(Change::Slower).count(), 0);
}

#[test]
fn counts_certificates_points_and_machines_are_compared_too() {
    let old = MadeUp::new(1).run();
    let mut new = MadeUp::new(1).run();
    new.counts[0].value += 5;
    new.cells[0].outcome = Outcome::Wrong;
    new.manifest.compiler = "another".into();
    let found = diff(&old, &new);
    assert_eq!(found.counts.len(), 1);
    assert_eq!(found.counts[0].after - found.counts[0].before, 5);
    assert_eq!(found.lost[0].outcome, "wrong");
    assert!(
        found
            .regression()
            .expect("lost")
            .contains("1 certificates are lost")
    );
    assert!(
        found
            .notes
            .iter()
            .any(|note| note.contains("compiler differs"))
    );

    let mut other = MadeUp::new(1).run();
    for cell in &mut other.cells {
        cell.fingerprint += "'";
    }
    let found = diff(&old, &other);
    assert!(found.rows.is_empty() && !found.notes.is_empty());
}
