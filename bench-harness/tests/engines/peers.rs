//! `hullbench peers`, and every peer that is built: the same hull as the library.

use bench_harness::counting::PointSet;
use bench_harness::engine::answer::Answer;
use bench_harness::engine::catalogue::{Entry, Places};
use bench_harness::engine::client::Session;
use bench_harness::engine::cut::cuts_up;
use bench_harness::engine::peers::{self, Peer};
use bench_harness::engine::protocol::{Convention, Problem, Run};
use geometry_core::{Boundary, Points};
use hull_verify::check;
use point_sets::Spec;
use std::num::NonZeroU32;
use std::process::{Command, Output};
use std::time::Duration;

fn hullbench(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_hullbench"))
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn peers_that_are_not_built_are_listed_with_what_is_missing() {
    let cache = tempfile::tempdir().unwrap();
    let cache = cache.path().to_str().unwrap();
    let output = hullbench(&["peers", "list", "--cache", cache]);
    assert!(output.status.success(), "{output:?}");
    let table = String::from_utf8(output.stdout).unwrap();
    for name in ["qhull", "cgal-3d", "scipy", "spade"] {
        let line = table
            .lines()
            .find(|line| line.split(' ').next() == Some(name));
        assert!(line.unwrap().contains("not built"), "{table}");
    }
}

#[test]
fn the_list_as_json_holds_everything() {
    let cache = tempfile::tempdir().unwrap();
    let cache = cache.path().to_str().unwrap();
    let output = hullbench(&["peers", "list", "--format", "json", "--cache", cache]);
    let list: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(list.as_array().unwrap().len(), peers::all().count());
    assert_eq!(list[0]["name"], "qhull");
    assert_eq!(list[0]["problems"][1], "hull3");
    assert!(list[0]["missing"].is_string() && list[0]["receipt"].is_null());
}

#[test]
fn a_named_peer_that_is_missing_is_a_failure() {
    let cache = tempfile::tempdir().unwrap();
    let cache = cache.path().to_str().unwrap();
    let output = hullbench(&["peers", "list", "qhull", "--cache", cache]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let output = hullbench(&["peers", "build", "qhul", "--cache", cache]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("did you mean 'qhull'?"));
}

#[test]
fn without_a_compiler_only_the_compiler_is_missing() {
    let cache = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_hullbench"))
        .args(["peers", "build", "geos", "qhull", "--cache"])
        .arg(cache.path())
        .env("CXX", "/nowhere/compiler")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let table = String::from_utf8(output.stdout).unwrap();
    let needs = table
        .lines()
        .filter(|line| line.contains("needs the program g++ (Debian: g++)"));
    assert_eq!(needs.count(), 2, "{table}");
    assert!(!table.contains("header"), "{table}");
}

#[test]
fn an_interpreter_without_the_modules_is_missing_them() {
    let cache = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_hullbench"))
        .args(["peers", "build", "scipy", "--cache"])
        .arg(cache.path())
        // Tells its version, and imports nothing.
        .env("HULLBENCH_PYTHON", env!("CARGO_BIN_EXE_hullbench"))
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(table.contains("numpy and scipy.spatial"), "{table}");
}

#[test]
fn sources_that_are_not_there_are_missing() {
    let empty = tempfile::tempdir().unwrap();
    let empty = empty.path().to_str().unwrap();
    let output = hullbench(&[
        "peers",
        "build",
        "qhull",
        "--sources",
        empty,
        "--cache",
        empty,
    ]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(table.contains("needs its source"), "{table}");
}

/// Points of the plane and of space that are easy for everyone: nothing flat, nothing nearly flat, no copies.
const EASY: usize = 200;
/// Sets in a batch.
const SETS: u64 = 6;
const LIMIT: Duration = Duration::from_secs(60);

#[track_caller]
fn answer<const D: usize>(
    peer: &Peer,
    session: &mut Session,
    problem: Problem,
    points: &[[f64; D]],
) -> Answer {
    let done = session
        .load(problem, Convention::Extreme, points, LIMIT)
        .and_then(|()| session.run(Run::ONCE, LIMIT))
        .and_then(|_| session.hull(LIMIT));
    done.unwrap_or_else(|fault| panic!("{} {problem}: {fault}", peer.name))
}

/// Sets of easy points for `problem`, no two alike.
fn easy(problem: Problem) -> Vec<PointSet> {
    let spec = |name: &str| name.parse::<Spec>().unwrap();
    let set = |seed| match problem.dimension() {
        2 => PointSet::Plane(spec("disc").generate(EASY, seed).unwrap()),
        _ => PointSet::Space(spec("ball").generate3(EASY, seed).unwrap()),
    };
    (0..SETS).map(set).collect()
}

/// Whether the checker accepts what `peer` says about every set of a batch, after two passes.
fn judge(peer: &Peer, session: &mut Session, problem: Problem) -> Result<(), String> {
    let sets = easy(problem);
    let twice = Run {
        samples: NonZeroU32::MIN,
        inner: NonZeroU32::new(2).unwrap(),
    };
    session
        .load_sets(problem, Convention::Extreme, &sets, LIMIT)
        .and_then(|()| session.run(twice, LIMIT))
        .map_err(|fault| format!("{}: {fault}", peer.name))?;
    for (number, set) in (0..).zip(&sets) {
        let answer = session.hull_of(number, LIMIT);
        let answer = answer.map_err(|fault| format!("set {number}: {fault}"))?;
        judge_one(problem, set, &answer).map_err(|what| format!("set {number}: {what}"))?;
    }
    match session.hull_of(SETS as u32, LIMIT) {
        Err(fault) if fault.leaves_it_running() => Ok(()),
        other => Err(format!("a hull of no set: {other:?}")),
    }
}

fn judge_one(problem: Problem, set: &PointSet, answer: &Answer) -> Result<(), String> {
    match (problem, set) {
        (Problem::Hull2, PointSet::Plane(points)) => {
            let hull = answer.hull2(Points::new(points).unwrap());
            let hull = hull.ok_or("no cycle")?;
            let checked = check::hull2(points, Boundary::Extreme, &hull);
            checked.map(drop).map_err(|f| format!("{f:?}"))
        }
        (Problem::Hull3, PointSet::Space(points)) => {
            let hull = hullkit::convex_hull_3d(points).unwrap();
            check::hull3(points, &hull).map_err(|f| format!("{f:?}"))?;
            cuts_up(&answer.triangles().ok_or("no triangles")?, &hull)
        }
        (Problem::Delaunay, PointSet::Plane(points)) => {
            let triangulation = answer.triangulation().ok_or("no triangles")?;
            let checked = check::delaunay(points, &triangulation);
            checked.map(drop).map_err(|f| format!("{f:?}"))
        }
        _ => Err("no peer peels".into()),
    }
}

#[test]
#[allow(clippy::print_stderr)]
fn every_peer_that_is_built_is_right_about_easy_points() {
    let places = Places::find(None, None).unwrap();
    for (program, peer) in peers::all() {
        let launch = match Entry::Peer(program, peer).launch(&places) {
            Ok(launch) => launch,
            Err(fault) => {
                eprintln!("{}: {fault}", peer.name);
                continue;
            }
        };
        let mut session = Session::start(&launch, LIMIT).unwrap();
        assert!(session.receipt().clock_ns > 0, "{}", peer.name);
        for &problem in peer.problems {
            assert_eq!(
                judge(peer, &mut session, problem),
                Ok(()),
                "{} {problem}",
                peer.name
            );
        }
        session.quit(LIMIT);
    }
}

#[test]
fn copies_are_named_by_the_smallest_index() {
    let places = Places::find(None, None).unwrap();
    let square = [
        [2.0, 2.0],
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 2.0],
        [0.0, 2.0],
        [1.0, 1.0],
        [0.0, -0.0],
    ];
    for (program, peer) in peers::all() {
        let Ok(launch) = Entry::Peer(program, peer).launch(&places) else {
            continue;
        };
        if peer.problems.contains(&Problem::Hull2) {
            let mut session = Session::start(&launch, LIMIT).unwrap();
            let vertices = answer(peer, &mut session, Problem::Hull2, &square).vertices();
            assert_eq!(vertices, [0, 1, 2, 4], "{}", peer.name);
        }
    }
}

#[test]
fn a_convention_that_a_peer_does_not_know_is_refused() {
    let places = Places::find(None, None).unwrap();
    for (program, peer) in peers::all() {
        let Ok(launch) = Entry::Peer(program, peer).launch(&places) else {
            continue;
        };
        if peer.problems.contains(&Problem::Hull2) {
            let mut session = Session::start(&launch, LIMIT).unwrap();
            let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
            let fault = session
                .load(Problem::Hull2, Convention::All, &points, LIMIT)
                .unwrap_err();
            assert_eq!(fault.word(), "refused", "{}: {fault}", peer.name);
        }
    }
}
