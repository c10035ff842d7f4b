//! Instructions of a call, as valgrind counts them.
//!
//! An engine is run twice from start to end under `valgrind --tool=cachegrind --cache-sim=no`: once with one call on the
//! set, once with two. What the second run executes more is one call. The count hardly depends on the machine, and not at
//! all on what else it does; but valgrind knows no AVX-512, so a program compiled for that alone does not run, and one
//! that chooses at run time is counted as on a processor without.

use crate::counting::PointSet;
use crate::engine::client::{Launch, Session};
use crate::engine::fault::Fault;
use crate::engine::protocol::{Convention, Problem, Run};
use std::ffi::OsString;
use std::num::NonZeroU32;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// The name of the counter.
pub(super) const COUNTER: &str = "instructions";

/// What is asked of an engine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Question<'a> {
    pub(super) problem: Problem,
    pub(super) boundary: Convention,
    pub(super) set: &'a PointSet,
    /// How long a reply may take.
    pub(super) limit: Duration,
}

/// Whether there is a valgrind.
pub(super) fn can_count() -> bool {
    let mut valgrind = Command::new("valgrind");
    let asked = valgrind.arg("--version").stdin(Stdio::null()).output();
    asked.is_ok_and(|output| output.status.success())
}

/// The instructions of one call of the engine that `launch` starts.
///
/// # Errors
///
/// What the engine does wrong under valgrind, or that valgrind says nothing.
pub(super) fn of_a_call(launch: &Launch, question: &Question<'_>) -> Result<u64, Fault> {
    let folder = tempfile::tempdir().map_err(|error| Fault::Absent {
        missing: format!("a folder for valgrind's log: {error}"),
    })?;
    let once = of_a_process(launch, question, 1, &folder.path().join("once.log"))?;
    let twice = of_a_process(launch, question, 2, &folder.path().join("twice.log"))?;
    Ok(twice.saturating_sub(once))
}

/// The instructions of a whole process that makes `calls` calls.
fn of_a_process(
    launch: &Launch,
    question: &Question<'_>,
    calls: u32,
    log: &Path,
) -> Result<u64, Fault> {
    let mut session = Session::start(&under_valgrind(launch, log), question.limit)?;
    let sets = std::slice::from_ref(question.set);
    session.load_sets(question.problem, question.boundary, sets, question.limit)?;
    let run = Run {
        samples: NonZeroU32::MIN,
        inner: NonZeroU32::new(calls).unwrap_or(NonZeroU32::MIN),
    };
    session.run(run, question.limit)?;
    session.quit(question.limit);
    let text = std::fs::read_to_string(log).unwrap_or_default();
    references(&text).ok_or_else(|| Fault::Garbled {
        expected: "valgrind's count of instructions".to_owned(),
        got: text.lines().last().unwrap_or("nothing").to_owned(),
    })
}

fn under_valgrind(launch: &Launch, log: &Path) -> Launch {
    let mut log_file = OsString::from("--log-file=");
    log_file.push(log);
    let options = [
        "--tool=cachegrind",
        "--cache-sim=no",
        "--cachegrind-out-file=/dev/null",
    ];
    let options = options.map(OsString::from).into_iter();
    let program = [log_file, launch.program.clone().into_os_string()];
    Launch {
        engine: launch.engine.clone(),
        program: "valgrind".into(),
        arguments: options
            .chain(program)
            .chain(launch.arguments.iter().cloned())
            .collect(),
    }
}

/// The number in the line `==PID== I   refs:      561,944`.
fn references(log: &str) -> Option<u64> {
    let mut counts = log.lines().filter_map(|line| {
        let (_, rest) = line.split_once("== I ")?;
        let (_, number) = rest.split_once("refs:")?;
        number.trim().replace(',', "").parse().ok()
    });
    counts.next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_found_in_the_log() {
        let log = "==7== Cachegrind, a cache profiler\n--7-- warning: L3 cache found\n==7== \n==7== I   refs:      1,561,944\n";
        assert_eq!(references(log), Some(1_561_944));
        assert_eq!(references("==7== Process terminating: SIGILL"), None);
    }
}
