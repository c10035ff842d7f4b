//! `hullbench measure` as a user runs it: interrupted, gone on with, and lied to.

mod interrupted;
mod liars;

use assert_cmd::cargo::cargo_bin;
use bench_harness::records::Run;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// A folder with a definition in it.
struct Bench {
    folder: TempDir,
}

impl Bench {
    /// One small definition: two sets at two sizes, the smaller in batches of four, two methods and a twin.
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let text = r#"
id = "small"
group = "tests"
task = "hull2"
seed = 7
question = "Is anything lost?"

[[cells]]
sets = ["disc", "lattice"]
n = [50, 400]
engines = ["gs", "monotone-chain"]
measure = ["time", "counts"]
realisations = 2
rounds = 4
points_a_batch = 200
twin = "gs"
timeout_seconds = 2
"#;
        std::fs::write(folder.path().join("small.toml"), text).expect("written");
        Self { folder }
    }

    fn run(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// `hullbench measure` of the definition into the run called `name`.
    fn measure(&self, name: &str) -> Command {
        let mut command = Command::new(cargo_bin("hullbench"));
        command
            .arg("measure")
            .arg(self.folder.path().join("small.toml"));
        command.arg("--run").arg(self.run(name));
        command
    }
}

fn load(folder: &Path) -> Run {
    Run::load(folder).expect("a whole run")
}
