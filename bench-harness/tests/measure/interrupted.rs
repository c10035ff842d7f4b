//! A run that is killed goes on, and ends as if nothing had happened.

use super::{Bench, load};
use bench_harness::records::Run;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

/// What must be the same however often a run was interrupted: everything but times and peaks of memory.
fn content(run: &Run) -> Vec<String> {
    let cells = run.cells.iter().map(|cell| format!("{cell:?}"));
    let samples = run
        .samples
        .iter()
        .map(|sample| format!("{} round {}", sample.subject, sample.round));
    let counts = run
        .counts
        .iter()
        .filter(|count| count.counter != "peak_bytes");
    let counts = counts.map(|count| format!("{count:?}"));
    let mut content: Vec<String> = cells.chain(samples).chain(counts).collect();
    content.sort();
    content
}

#[test]
fn a_killed_run_loses_nothing_and_doubles_nothing() {
    let bench = Bench::new();
    assert!(bench.measure("whole").status().expect("a run").success());
    let seed = 20_260;
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut kills = 0;
    loop {
        let mut child = bench
            .measure("killed")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("a run");
        sleep(Duration::from_millis(random.random_range(20..400)));
        match child.try_wait().expect("a child") {
            Some(status) => {
                assert!(status.success(), "after {kills} kills, seed {seed}");
                break;
            }
            None if kills < 6 => {
                child.kill().expect("killed");
                child.wait().expect("gone");
                kills += 1;
            }
            None => {
                assert!(child.wait().expect("a child").success(), "seed {seed}");
                break;
            }
        }
    }
    assert!(kills > 0, "the run was over before it could be killed");
    let [whole, killed] = ["whole", "killed"].map(|name| load(&bench.run(name)));
    assert_eq!(content(&whole), content(&killed), "seed {seed}");
    // Two sets, two sizes, two realisations, four rounds, three contestants.
    assert_eq!(whole.samples.len(), 2 * 2 * 2 * 4 * 3);
}

#[test]
fn a_run_of_another_text_is_left_alone() {
    let bench = Bench::new();
    assert!(bench.measure("run").status().expect("a run").success());
    let path = bench.folder.path().join("small.toml");
    let text = std::fs::read_to_string(&path).expect("text");
    std::fs::write(&path, text.replace("seed = 7", "seed = 8")).expect("written");
    let output = bench.measure("run").output().expect("a run");
    assert_eq!(output.status.code(), Some(3));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        message.contains("another text of the definition 'small'"),
        "{message}"
    );
}
