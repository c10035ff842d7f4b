//! `export`: the formats of other tools.

use crate::made_up::MadeUp;
use bench_harness::analysis::export::{Tool, export};

const NAME: &str = "made-up/disc/1000/gs";

#[test]
fn github_action_benchmark_has_name_unit_and_value() {
    let value = export(&MadeUp::new(4).run(), Tool::GithubActionBenchmark);
    let entries = value.as_array().expect("an array");
    assert_eq!(entries.len(), 24);
    let entry = entries
        .iter()
        .find(|entry| entry["name"] == NAME)
        .expect("a benchmark");
    assert_eq!(entry["unit"], "ns");
    assert!(entry["value"].as_f64().expect("a number") > 1e4);
    assert!(entry["range"].as_str().expect("text").starts_with("± "));
}

#[test]
fn bencher_has_times_and_counts_as_measures() {
    let value = export(&MadeUp::new(4).run(), Tool::Bencher);
    let latency = &value[NAME]["latency"];
    let number = |key: &str| latency[key].as_f64().expect("a number");
    assert!(number("lower_value") <= number("value") && number("value") <= number("upper_value"));
    assert!(value[NAME]["orient"]["value"].as_f64().expect("a count") > 1e4);
}

#[test]
fn criterion_has_what_critcmp_reads() {
    let value = export(&MadeUp::new(4).run(), Tool::Criterion);
    let benchmark = &value["benchmarks"][NAME];
    assert!(value["name"].is_string() && benchmark["baseline"] == value["name"]);
    let info = &benchmark["criterion_benchmark_v1"];
    assert_eq!(
        (&info["full_id"], &info["function_id"]),
        (&NAME.into(), &"gs".into())
    );
    for estimate in ["mean", "median", "median_abs_dev", "std_dev"] {
        let estimate = &benchmark["criterion_estimates_v1"][estimate];
        assert!(estimate["point_estimate"].is_f64() && estimate["standard_error"].is_f64());
        assert!(estimate["confidence_interval"]["upper_bound"].is_f64());
    }
}
