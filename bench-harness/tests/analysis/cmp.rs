//! `cmp`: who is faster, and what stays open.

use crate::made_up::MadeUp;
use bench_harness::analysis::cmp::{Standing, cmp};
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

#[test]
fn equal_engines_stay_open() {
    let mut sure = 0;
    for seed in 0..20 {
        let plan = MadeUp {
            engines: vec![("gs", 1.0), ("eddy", 1.0)],
            sizes: vec![1_000],
            sets: vec!["disc"],
            seeds: 6,
            ..MadeUp::new(seed)
        };
        let answer = cmp(&plan.run(), Some("gs"));
        sure += answer
            .rows
            .iter()
            .filter(|row| matches!(row.standing, Standing::Faster | Standing::Slower))
            .count();
    }
    // Engine and realisation have 5 % of their own, drawn once for all runs.
    assert!(sure <= 20, "{sure}");
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
