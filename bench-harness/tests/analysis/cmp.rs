//! `cmp`: who is faster, and what stays open.

use crate::made_up::MadeUp;
use bench_harness::analysis::cmp::{Row, Standing, cmp};
use bench_harness::records::Outcome;

#[test]
fn ratios_come_back_and_the_fastest_is_the_baseline() {
    let answer = cmp(&MadeUp::new(5).run(), None);
    assert_eq!(answer.rows.len(), 24);
    assert!(answer.band.twins == 12 && answer.band.half_width < 0.03);
    for row in &answer.rows {
        match row.engine.as_str() {
            "gs" => assert_eq!(row.standing, Standing::Baseline),
            engine => {
                let truth = [("eddy", 1.4), ("graham", 2.0), ("qhull", 3.1)];
                let truth = truth.iter().find(|(name, _)| *name == engine);
                let truth = truth.expect("an engine").1;
                let ratio = row.ratio.expect("a ratio");
                assert_eq!(row.standing, Standing::Slower);
                assert!(
                    (ratio.ratio / truth - 1.0).abs() < 0.15,
                    "{engine}: {ratio:?}"
                );
                assert!(ratio.low < ratio.ratio && ratio.ratio < ratio.high);
                assert!(ratio.wilcoxon < 1e-3);
            }
        }
        assert!(row.h.is_some() && row.shortest <= row.nanoseconds);
    }
    let text = answer.page().markdown();
    assert!(text.contains("h = ") && text.contains("A/A band"), "{text}");
}

/// On how many of 60 worlds two engines of the same cost are surely unlike, if engine and realisation have so much of
/// their own.
fn sure_of_equal_engines(own: f64, seeds: u64) -> usize {
    let sure = (0..60).filter(|world| {
        let plan = MadeUp {
            engines: vec![("gs", 1.0), ("eddy", 1.0)],
            twins: vec!["gs"],
            sizes: vec![1_000],
            sets: vec!["disc"],
            seeds,
            own,
            world: *world,
            ..MadeUp::new(*world)
        };
        let answer = cmp(&plan.run(), Some("gs"));
        let surely = |row: &Row| matches!(row.standing, Standing::Faster | Standing::Slower);
        answer.rows.iter().any(surely)
    });
    sure.count()
}

#[test]
fn equal_engines_stay_open_however_much_realisations_differ() {
    for (own, seeds) in [(0.0, 2), (0.05, 6), (0.2, 4)] {
        let sure = sure_of_equal_engines(own, seeds);
        assert!(sure <= 6, "own {own}, {seeds} seeds: {sure} of 60");
    }
}

#[test]
fn what_is_not_certified_is_listed_with_its_reason() {
    let mut run = MadeUp::new(5).run();
    for cell in &mut run.cells {
        if cell.subject.engine == "qhull" {
            cell.outcome = Outcome::Refused;
            cell.finding = "coplanar".into();
        }
    }
    let answer = cmp(&run, None);
    assert_eq!(answer.uncertified.len(), 6);
    assert!(answer.uncertified.iter().all(|row| row.realisations == 4));
    assert!(answer.page().markdown().contains("coplanar"));
}
