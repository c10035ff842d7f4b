//! `rank`: the order, and who was not measured everywhere.

use crate::made_up::MadeUp;
use bench_harness::analysis::rank::rank;

#[test]
fn the_order_and_the_means_come_back() {
    let answer = rank(&MadeUp::new(2).run());
    let names: Vec<&str> = answer
        .ranked
        .iter()
        .map(|row| row.engine.as_str())
        .collect();
    assert_eq!(names, ["gs", "eddy", "graham", "qhull"]);
    assert_eq!((answer.ranked[0].wins, answer.ranked[0].cases), (6, 6));
    for (row, truth) in answer.ranked.iter().zip([1.0, 1.4, 2.0, 3.1]) {
        assert!((row.mean_ratio / truth - 1.0).abs() < 0.06, "{row:?}");
        assert!(row.low <= row.mean_ratio && row.mean_ratio <= row.high);
    }
}

#[test]
fn an_engine_of_easy_cases_stands_last_and_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    MadeUp::new(2).write(folder.path());
    let path = folder.path().join("samples.csv");
    let text = std::fs::read_to_string(&path).expect("samples");
    let kept = text.lines().filter(|line| {
        let hard = line.contains(",10000,") || line.contains(",1000,");
        !(hard && (line.contains(",gs,") || line.contains(",gs@twin,")))
    });
    std::fs::write(
        &path,
        kept.map(|line| format!("{line}\n")).collect::<String>(),
    )
    .expect("cut");
    let run = bench_harness::records::Run::load(folder.path()).expect("a run");
    let answer = rank(&run);
    let last = answer.ranked.last().expect("a last");
    assert_eq!((last.engine.as_str(), last.cases), ("gs", 2));
    assert!(answer.page().markdown().contains("only 2 of 6"));
}
