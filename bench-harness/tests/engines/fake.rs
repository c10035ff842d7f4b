//! Every misbehaviour becomes its outcome, in time, and leaves no process behind.

use bench_harness::counting::PointSet;
use bench_harness::engine::client::{Launch, Session};
use bench_harness::engine::fault::Fault;
use bench_harness::engine::protocol::{Convention, Problem, Run};
use geometry_core::{Boundary, Points};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// Long enough for anything that will come at all.
const LONG: Duration = Duration::from_secs(60);
/// Long enough to be sure that nothing comes.
const SHORT: Duration = Duration::from_millis(300);
/// How late we may notice that a deadline has passed, on a machine that has hardly any time for us. The peers here would
/// sleep for an hour.
const GRACE: Duration = Duration::from_secs(60);

const SQUARE: [[f64; 2]; 5] = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];

/// The program, which is an example of this package, so that it is never installed.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    let test = env::current_exe().unwrap();
    let profile_folder = test.parent().and_then(Path::parent).unwrap();
    let profile = profile_folder.file_name().unwrap().to_str().unwrap();
    let profile = if profile == "debug" { "dev" } else { profile };
    let status = Command::new(env!("CARGO"))
        .args([
            "build",
            "--quiet",
            "--package",
            "bench-harness",
            "--example",
            "fake-peer",
        ])
        .args(["--profile", profile, "--target-dir"])
        .arg(profile_folder.parent().unwrap())
        .status()
        .unwrap();
    assert!(status.success());
    profile_folder.join("examples/fake-peer")
});

fn launch(arguments: &[&str]) -> Launch {
    Launch {
        engine: "fake".into(),
        program: PROGRAM.clone(),
        arguments: arguments.iter().map(Into::into).collect(),
    }
}

fn loaded(mode: &str) -> Session {
    let mut session = Session::start(&launch(&[mode]), LONG).unwrap();
    session
        .load(Problem::Hull2, Convention::Extreme, &SQUARE, LONG)
        .unwrap();
    session
}

fn ran(mode: &str) -> Session {
    let mut session = loaded(mode);
    session.run(Run::ONCE, LONG).unwrap();
    session
}

#[track_caller]
fn assert_gone(process: u32) {
    let folder = PathBuf::from(format!("/proc/{process}"));
    assert!(!folder.exists(), "process {process} is still there");
}

/// Whether the conversation is over: the same fault again, at once, and no process.
#[track_caller]
fn assert_over(mut session: Session, fault: &Fault) {
    assert_gone(session.id());
    assert_eq!(session.run(Run::ONCE, LONG).as_ref(), Err(fault));
    assert_eq!(session.hull(LONG).as_ref(), Err(fault));
}

#[test]
fn an_honest_peer_is_believed() {
    let mut session = ran("honest");
    let answer = session.hull(LONG).unwrap();
    let view = Points::new(&SQUARE).unwrap();
    let hull = answer.hull2(view).unwrap();
    assert!(hull_verify::check::hull2(&SQUARE, Boundary::Extreme, &hull).is_ok());
    let process = session.id();
    session.quit(LONG);
    assert_gone(process);
}

#[test]
fn a_slow_peer_is_waited_for() {
    let mut session = loaded("slow");
    let timed = session.run(Run::ONCE, LONG).unwrap();
    assert_eq!(timed.nanoseconds.len(), 1);
    assert!(timed.elapsed >= Duration::from_millis(200));
}

#[test]
fn a_lie_is_well_formed_and_refuted_by_the_checker() {
    let answer = ran("lie").hull(LONG).unwrap();
    let hull = answer.hull2(Points::new(&SQUARE).unwrap()).unwrap();
    assert!(hull_verify::check::hull2(&SQUARE, Boundary::Extreme, &hull).is_err());
}

#[test]
fn no_version_no_measurement() {
    let folder = tempfile::tempdir().unwrap();
    for (mode, limit, outcome) in [
        ("silent", SHORT, "timeout"),
        ("chatter", LONG, "garbled"),
        ("flood", LONG, "garbled"),
        ("quitter", LONG, "garbled"),
        ("impostor", LONG, "garbled"),
        ("future", LONG, "garbled"),
    ] {
        let file = folder.path().join(mode);
        let start = Instant::now();
        let fault = Session::start(&launch(&[mode, file.to_str().unwrap()]), limit).unwrap_err();
        assert_eq!(fault.word(), outcome, "{mode}: {fault}");
        assert!(start.elapsed() < limit + GRACE, "{mode}");
        // A busy machine may have had no time for it to write the file: then it was killed before.
        if let Ok(process) = fs::read_to_string(&file).unwrap_or_default().parse() {
            assert_gone(process);
        }
    }
}

#[test]
fn a_program_that_is_not_there_is_absent() {
    let mut nobody = launch(&[]);
    nobody.program = "/nowhere/nobody".into();
    assert_eq!(Session::start(&nobody, LONG).unwrap_err().word(), "absent");
}

#[test]
fn a_hanging_peer_is_killed_in_time() {
    let mut session = loaded("hang");
    let start = Instant::now();
    let fault = session.run(Run::ONCE, SHORT).unwrap_err();
    let taken = start.elapsed();
    assert!(taken >= SHORT && taken < SHORT + GRACE, "{taken:?}");
    let limit = SHORT;
    assert_eq!(
        fault,
        Fault::Timeout {
            command: "run",
            limit
        }
    );
    assert_over(session, &fault);
}

#[test]
fn a_peer_that_does_not_read_cannot_hold_us_up() {
    let mut session = Session::start(&launch(&["deaf"]), LONG).unwrap();
    // Far more than fits a pipe.
    let points = vec![[0.5, 0.25]; 1_000_000];
    let start = Instant::now();
    let fault = session
        .load(Problem::Hull2, Convention::Extreme, &points, SHORT)
        .unwrap_err();
    assert!(start.elapsed() < SHORT + GRACE);
    let (command, limit) = ("load", SHORT);
    assert_eq!(fault, Fault::Timeout { command, limit });
    assert_over(session, &fault);
}

#[test]
fn points_that_were_lost_are_noticed() {
    let mut session = Session::start(&launch(&["forgetful"]), LONG).unwrap();
    let fault = session
        .load(Problem::Hull2, Convention::Extreme, &SQUARE, LONG)
        .unwrap_err();
    assert_eq!(fault.word(), "garbled", "{fault}");
    assert_over(session, &fault);
}

#[test]
fn a_peer_that_knows_nothing_of_batches_does_one_set() {
    let mut session = Session::start(&launch(&["single"]), LONG).unwrap();
    session
        .load(Problem::Hull2, Convention::Extreme, &SQUARE, LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    assert_eq!(session.hull(LONG).unwrap().vertices(), [0, 1, 3, 4]);
    let sets = [0, 1].map(|_| PointSet::Plane(SQUARE.to_vec()));
    let fault = session
        .load_sets(Problem::Hull2, Convention::Extreme, &sets, LONG)
        .unwrap_err();
    assert_eq!(fault.word(), "garbled", "{fault}");
    assert_over(session, &fault);
}

#[test]
fn a_crash_is_recorded_with_its_last_words() {
    for (mode, ending, words) in [
        ("crash", "SIGABRT", "about to fail"),
        ("exit", "exit status: 3", "cannot go on"),
    ] {
        let mut session = loaded(mode);
        let fault = session.run(Run::ONCE, LONG).unwrap_err();
        let Fault::Crashed { status, stderr } = &fault else {
            panic!("{mode}: {fault:?}");
        };
        assert!(status.contains(ending), "{status}");
        assert!(stderr.contains(words), "{stderr}");
        assert_over(session, &fault);
    }
}

#[test]
fn samples_that_cannot_be_are_garbled() {
    for mode in ["mumble", "boast", "stingy"] {
        let mut session = loaded(mode);
        let fault = session.run(Run::ONCE, LONG).unwrap_err();
        assert_eq!(fault.word(), "garbled", "{mode}: {fault}");
        assert_over(session, &fault);
    }
}

#[test]
fn hulls_that_cannot_be_are_garbled() {
    for mode in ["truncate", "stranger", "huge", "endless"] {
        let mut session = ran(mode);
        let fault = session.hull(LONG).unwrap_err();
        assert_eq!(fault.word(), "garbled", "{mode}: {fault}");
        assert_over(session, &fault);
    }
}

#[test]
fn a_refusal_is_no_end() {
    let mut session = Session::start(&launch(&["picky"]), LONG).unwrap();
    let fault = session
        .load(Problem::Hull2, Convention::Extreme, &SQUARE, LONG)
        .unwrap_err();
    let reason = "too few points".to_owned();
    assert_eq!(fault, Fault::Refused { reason });
    assert_eq!(session.hull(LONG).unwrap_err().word(), "refused");
    let many = SQUARE.repeat(2);
    session
        .load(Problem::Hull2, Convention::Extreme, &many, LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    assert_eq!(session.hull(LONG).unwrap().vertices(), [0, 1, 3, 4]);
}

#[test]
fn what_an_engine_does_not_do_is_not_asked() {
    let mut session = Session::start(&launch(&["honest"]), LONG).unwrap();
    let fault = session
        .load(Problem::Delaunay, Convention::Extreme, &SQUARE, LONG)
        .unwrap_err();
    assert_eq!(fault.word(), "refused");
    let fault = session
        .load(Problem::Hull3, Convention::Extreme, &SQUARE, LONG)
        .unwrap_err();
    assert_eq!(fault.word(), "refused");
}

#[test]
fn a_dropped_session_leaves_no_process() {
    let session = loaded("hang");
    let process = session.id();
    drop(session);
    assert_gone(process);
}
