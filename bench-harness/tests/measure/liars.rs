//! What a program that misbehaves says never reaches a table.

use super::{Bench, load};
use bench_harness::records::Outcome;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// An example of this package, so that it is never installed.
static FAKE: LazyLock<PathBuf> = LazyLock::new(|| {
    let test = std::env::current_exe().expect("this test");
    let profile_folder = test
        .parent()
        .and_then(Path::parent)
        .expect("target/PROFILE/deps");
    let profile = profile_folder
        .file_name()
        .and_then(|name| name.to_str())
        .expect("a profile");
    let status = Command::new(env!("CARGO"))
        .args([
            "build",
            "--quiet",
            "--package",
            "bench-harness",
            "--example",
            "fake-peer",
        ])
        .args([
            "--profile",
            if profile == "debug" { "dev" } else { profile },
            "--target-dir",
        ])
        .arg(profile_folder.parent().expect("target"))
        .status()
        .expect("cargo");
    assert!(status.success());
    profile_folder.join("examples/fake-peer")
});

/// What became of the fake in every cell, and what the tables say.
fn told(mode: &str) -> (Vec<Outcome>, String) {
    let bench = Bench::new();
    let mut measure = bench.measure(mode);
    measure.args([
        "--realisations",
        "1",
        "--with",
        &format!("fake={} {mode}", FAKE.display()),
    ]);
    assert!(measure.status().expect("a run").success());
    let folder = bench.run(mode);
    let run = load(&folder);
    let fake = run
        .cells
        .iter()
        .filter(|cell| cell.subject.engine == "fake");
    let outcomes = fake.map(|cell| cell.outcome).collect();
    assert!(
        run.samples
            .iter()
            .all(|sample| sample.subject.engine != "fake")
    );
    let mut tables = String::new();
    for question in ["cmp", "rank", "table"] {
        let output = Command::new(assert_cmd::cargo::cargo_bin("hullbench"))
            .arg(question)
            .arg(&folder)
            .output()
            .expect("a table");
        assert!(output.status.success(), "{question}");
        tables += &String::from_utf8_lossy(&output.stdout);
    }
    (outcomes, tables)
}

#[test]
fn a_wrong_hull_is_shown_as_wrong_and_never_timed() {
    let (outcomes, tables) = told("lie");
    assert_eq!(outcomes, [Outcome::Wrong; 4]);
    assert!(tables.contains("wrong"), "{tables}");
}

#[test]
fn whoever_is_right_about_the_first_set_of_a_batch_only_is_wrong() {
    let bench = Bench::new();
    let mut measure = bench.measure("stale");
    let guest = format!("fake={} stale", FAKE.display());
    measure.args(["--realisations", "1", "--with", &guest]);
    assert!(measure.status().expect("a run").success());
    let run = load(&bench.run("stale"));
    let of_fake = run
        .cells
        .iter()
        .filter(|cell| cell.subject.engine == "fake");
    for cell in of_fake {
        // A lattice is the same whatever the seed.
        let case = &cell.subject.case;
        let differ = case.n == 50 && case.set == "disc";
        let due = if differ {
            Outcome::Wrong
        } else {
            Outcome::Certified
        };
        assert_eq!(cell.outcome, due, "{}: {}", cell.subject, cell.finding);
        assert_eq!(cell.finding.contains("3 of 4 sets"), differ);
    }
    let small = run.samples.iter().filter(|s| s.subject.case.n == 50);
    let calls: Vec<u64> = small.map(|sample| sample.inner.get()).collect();
    assert!(!calls.is_empty());
    assert!(calls.iter().all(|calls| calls % 4 == 0), "{calls:?}");
}

#[test]
fn whoever_boasts_crashes_or_truncates_is_recorded_as_such() {
    assert_eq!(told("boast").0, [Outcome::Garbled; 4]);
    assert_eq!(told("truncate").0, [Outcome::Garbled; 4]);
    assert_eq!(told("crash").0, [Outcome::Crashed; 4]);
}

#[test]
fn whoever_hangs_is_given_up_on_more_points() {
    assert_eq!(told("hang").0, [Outcome::Timeout; 4]);
}
