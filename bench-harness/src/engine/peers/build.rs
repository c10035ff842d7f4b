//! Building a peer into the cache.
//!
//! A built program is a folder of the cache with the program and `built.json`, which says how to start it and what it
//! was made from; it is written last, so a build that fails leaves nothing that looks built. A program whose sources
//! have changed since counts as not built.

use super::needs::{chosen, compiler, python};
use super::{Need, Program, Recipe};
use crate::engine::catalogue::Places;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What became of a build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was there already.
    Ready,
    /// It was built.
    Built,
    /// This must be installed first.
    Missing(Vec<String>),
    /// The build failed, and this is what is known.
    Failed(String),
}

/// How a built program is started: the name of the engine is the last argument.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Built {
    /// The program.
    pub program: PathBuf,
    /// The arguments before the name of the engine.
    pub arguments: Vec<PathBuf>,
    /// The sum of the sources.
    pub sources: String,
}

/// How to start `program`.
///
/// # Errors
///
/// What is missing, in words.
pub fn built(program: &Program, places: &Places) -> Result<Built, String> {
    let again = format!("run `hullbench peers build {}`", program.name);
    let text = fs::read(folder(program, places).join(RECORD))
        .map_err(|_| format!("not built: {again}"))?;
    let built: Built =
        serde_json::from_slice(&text).map_err(|_| format!("its build is not readable: {again}"))?;
    let is_there = |path: &PathBuf| path.is_relative() || path.exists();
    if !is_there(&built.program) || !built.arguments.iter().all(is_there) {
        return Err(format!("what was built is gone: {again}"));
    }
    let unchanged = match &places.sources {
        Some(sources) => sum(program, sources).is_ok_and(|sum| sum == built.sources),
        None => true,
    };
    if unchanged {
        Ok(built)
    } else {
        Err(format!("built from other sources: {again}"))
    }
}

/// Builds `program`, unless that is done.
pub fn build(program: &Program, places: &Places) -> Outcome {
    if built(program, places).is_ok() {
        return Outcome::Ready;
    }
    let holds = |folder: &&PathBuf| folder.join(program.sources[0]).is_file();
    let Some(sources) = places.sources.as_ref().filter(holds) else {
        return Outcome::Missing(vec![
            "its source (run in the workspace, or name the folder with --sources)".into(),
        ]);
    };
    let missing = missing(program);
    if !missing.is_empty() {
        return Outcome::Missing(missing);
    }
    match make(program, sources, &folder(program, places)) {
        Ok(()) => Outcome::Built,
        Err(what) => Outcome::Failed(what),
    }
}

/// What must be installed before `program` can be built, as far as that can be told: without a compiler nobody knows
/// which headers it would find.
pub fn missing(program: &Program) -> Vec<String> {
    let unmet = |are_programs: &dyn Fn(&Need) -> bool| -> Vec<String> {
        let needs = program.needs.iter().filter(|need| are_programs(need));
        let unmet = needs.filter(|need| !need.is_met());
        unmet.map(ToString::to_string).collect()
    };
    let is_program = |need: &Need| matches!(need, Need::Command { .. });
    let programs = unmet(&is_program);
    if !programs.is_empty() {
        return programs;
    }
    match program.recipe {
        Recipe::Python { modules } if python(modules).is_none() => vec![format!(
            "the Python modules {} (Debian: python3-scipy; or name an interpreter that has them in HULLBENCH_PYTHON)",
            modules.join(" and ")
        )],
        _ => unmet(&|need| !is_program(need)),
    }
}

const RECORD: &str = "built.json";

fn folder(program: &Program, places: &Places) -> PathBuf {
    places.cache.join(program.name)
}

/// Makes the program in `folder`, and its record.
fn make(program: &Program, sources: &Path, folder: &Path) -> Result<(), String> {
    let in_words = |error: io::Error| format!("{}: {error}", folder.display());
    fs::create_dir_all(folder).map_err(in_words)?;
    let record = folder.join(RECORD);
    match fs::remove_file(&record) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(in_words(error)),
        _ => {}
    }
    let main = sources.join(program.sources[0]);
    let (start, arguments) = match program.recipe {
        Recipe::Cpp { options, libraries } => {
            let target = folder.join(program.name);
            compile(&main, options, libraries, &target)?;
            (target, vec![])
        }
        Recipe::Python { modules } => {
            let python = python(modules).ok_or("the interpreter is gone")?;
            for source in program.sources {
                let path = sources.join(source);
                let name = path.file_name().unwrap_or_default();
                fs::copy(&path, folder.join(name)).map_err(in_words)?;
            }
            let script = folder.join(main.file_name().unwrap_or_default());
            (python.into(), vec![script])
        }
        Recipe::Cargo => (cargo(&sources.join("rust"), folder)?, vec![]),
    };
    let built = Built {
        program: start,
        arguments,
        sources: sum(program, sources).map_err(in_words)?,
    };
    let text = serde_json::to_vec(&built).map_err(|error| error.to_string())?;
    fs::write(record, text).map_err(in_words)
}

/// Compiles one file. A fused multiply-add would break every predicate that counts on rounding, hence
/// `-ffp-contract=off`; everything else is what makes a peer as fast as it can be on this machine.
fn compile(main: &Path, more: &[&str], libraries: &[&str], target: &Path) -> Result<(), String> {
    let options = [
        &[
            "-std=c++17",
            "-O3",
            "-march=native",
            "-DNDEBUG",
            "-ffp-contract=off",
        ],
        more,
    ]
    .concat();
    let mut command = Command::new(compiler());
    command
        .args(&options)
        .arg(format!("-DHULLBENCH_OPTIONS=\"{}\"", options.join(" ")))
        .arg("-o")
        .arg(target)
        .arg(main)
        .args(libraries);
    run(command, target)
}

/// Builds the workspace in `sources` and gives the path of its program.
fn cargo(sources: &Path, folder: &Path) -> Result<PathBuf, String> {
    const OPTIONS: &str = "-C target-cpu=native";
    let target = folder.join("target");
    let mut command = Command::new(chosen("CARGO", "cargo"));
    command
        .args([
            "build",
            "--release",
            "--locked",
            "--quiet",
            "--manifest-path",
        ])
        .arg(sources.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .env("RUSTFLAGS", OPTIONS)
        .env("HULLBENCH_OPTIONS", OPTIONS);
    let program = target.join("release/hullbench-peers");
    run(command, &target)?;
    Ok(program)
}

/// Runs `command`, which makes `target`, and keeps what it says beside it.
fn run(mut command: Command, target: &Path) -> Result<(), String> {
    let output = command
        .output()
        .map_err(|error| format!("{} cannot be run: {error}", command.get_program().display()))?;
    if output.status.success() {
        return Ok(());
    }
    let log = target.with_extension("log");
    let kept = fs::write(&log, &output.stderr).is_ok();
    let text = String::from_utf8_lossy(&output.stderr);
    let error = text.lines().find(|line| line.contains("error"));
    let error = error.or(text.lines().next_back()).unwrap_or("no message");
    let more = if kept {
        format!("; all of it is in {}", log.display())
    } else {
        String::new()
    };
    Err(format!("{}{more}", error.trim()))
}

/// The sum of all sources of `program`.
fn sum(program: &Program, sources: &Path) -> io::Result<String> {
    let mut digest = Sha256::new();
    for source in program.sources {
        let text = fs::read(sources.join(source))?;
        digest.update((text.len() as u64).to_le_bytes());
        digest.update(text);
    }
    Ok(digest
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect())
}
