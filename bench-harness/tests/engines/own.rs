//! Our methods over the pipe give what the library gives.

use bench_harness::counting::PointSet;
use bench_harness::engine::catalogue::{Entry, Places, find};
use bench_harness::engine::client::Session;
use bench_harness::engine::protocol::{Convention, Problem, Run};
use geometry_core::{Boundary, Method, Points, Task};
use point_sets::Spec;
use std::num::NonZeroU32;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

pub(super) const LONG: Duration = Duration::from_secs(120);
pub(super) const SEED: u64 = 11;

pub(super) fn places() -> Places {
    Places {
        hullbench: PathBuf::from(env!("CARGO_BIN_EXE_hullbench")),
        sources: None,
        cache: PathBuf::new(),
    }
}

pub(super) fn start(slug: &str) -> Session {
    let launch = find(slug)
        .expect("a registered slug")
        .launch(&places())
        .unwrap();
    Session::start(&launch, LONG).unwrap()
}

pub(super) fn disc(n: usize) -> Vec<[f64; 2]> {
    "disc".parse::<Spec>().unwrap().generate(n, SEED).unwrap()
}

pub(super) fn ball(n: usize) -> Vec<[f64; 3]> {
    "ball".parse::<Spec>().unwrap().generate3(n, SEED).unwrap()
}

/// The hull of a random set of the plane, both conventions, over the pipe and from the library.
fn assert_alike_in_plane(method: &Method, session: &mut Session, problem: Problem) {
    let points = disc(300);
    let view = Points::new(&points).unwrap();
    for boundary in [Boundary::Extreme, Boundary::All] {
        session
            .load(problem, boundary.into(), &points, LONG)
            .unwrap();
        session.run(Run::ONCE, LONG).unwrap();
        let answer = session.hull(LONG).unwrap();
        match method.task {
            Task::PlanarHull(task) => {
                assert_eq!(
                    answer.hull2(view),
                    (task.exact)(view, boundary).ok(),
                    "{}",
                    method.slug
                );
            }
            Task::PlanarLayers(task) => {
                assert_eq!(
                    answer.layers(view),
                    (task.exact)(view, boundary).ok(),
                    "{}",
                    method.slug
                );
            }
            Task::Delaunay(task) => {
                assert_eq!(
                    answer.triangulation(),
                    (task.exact)(view).ok(),
                    "{}",
                    method.slug
                );
            }
            _ => panic!("{} is not about the plane", method.slug),
        }
    }
}

fn assert_alike_in_space(method: &Method, session: &mut Session) {
    let points = ball(200);
    let view = Points::new(&points).unwrap();
    let Task::SpatialHull(task) = method.task else {
        panic!("{} is not about space", method.slug);
    };
    session
        .load(Problem::Hull3, Convention::Extreme, &points, LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    let answer = session.hull(LONG).unwrap();
    assert_eq!(
        answer.hull3(view),
        (task.exact)(view).ok(),
        "{}",
        method.slug
    );
}

#[test]
fn every_method_gives_the_hull_of_the_library() {
    for method in hullkit::methods() {
        let mut session = start(method.slug);
        let problem = Problem::of(method).expect("a word for what it computes");
        assert_eq!(session.receipt().tasks, [problem]);
        match problem.dimension() {
            2 => assert_alike_in_plane(method, &mut session, problem),
            _ => assert_alike_in_space(method, &mut session),
        }
        session.quit(LONG);
    }
}

#[test]
fn the_receipt_tells_version_and_clock() {
    let session = start("gs@twin");
    let receipt = session.receipt();
    assert_eq!(receipt.engine, "gs");
    assert_eq!(receipt.version, env!("CARGO_PKG_VERSION"));
    assert!(receipt.clock_ns > 0);
}

#[test]
fn samples_are_as_many_as_asked_and_grow_with_the_calls() {
    let mut session = start("gs");
    session
        .load(Problem::Hull2, Convention::Extreme, &disc(2000), LONG)
        .unwrap();
    let mut total = |inner| {
        let samples = NonZeroU32::new(20).unwrap();
        let inner = NonZeroU32::new(inner).unwrap();
        let timed = session.run(Run { samples, inner }, LONG).unwrap();
        assert_eq!(timed.nanoseconds.len(), 20);
        timed.nanoseconds.into_iter().min().unwrap()
    };
    let (one, hundred) = (total(1), total(100));
    assert!(
        hundred > 10 * one,
        "{hundred} ns for a hundred calls, {one} ns for one"
    );
}

#[test]
fn counts_are_exact_and_those_of_the_library() {
    let mut session = start("gs");
    let points = disc(500);
    session
        .load(Problem::Hull2, Convention::Extreme, &points, LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    let counters = session.counters(LONG).unwrap();
    let kernel = geometry_core::Counted::new(geometry_core::Exact);
    let mut tally = geometry_core::Tally::default();
    let Some(Task::PlanarHull(task)) = hullkit::method("gs").map(|method| method.task) else {
        panic!("gs is a planar hull method");
    };
    let view = Points::new(&points).unwrap();
    (task.tallied)(view, Boundary::Extreme, &kernel, &mut tally).unwrap();
    assert_eq!(
        counters["orientations"],
        kernel.counts().orientations.total()
    );
    assert_eq!(counters["visits"], tally.visits);
    assert!(counters["visits"] > 500);
}

#[test]
fn memory_grows_with_the_points() {
    let peak = |n| {
        let mut session = start("monotone-chain");
        session
            .load(Problem::Hull2, Convention::Extreme, &disc(n), LONG)
            .unwrap();
        session.run(Run::ONCE, LONG).unwrap();
        session.counters(LONG).unwrap().get("peak_bytes").copied()
    };
    if let (Some(few), Some(many)) = (peak(1000), peak(1_000_000)) {
        // An index of four bytes for each point, at least.
        assert!(many > few + 4_000_000, "{few} and {many}");
    }
}

#[test]
fn what_cannot_be_is_refused_with_a_reason() {
    let mut session = start("gs");
    let fault = session.hull(LONG).unwrap_err();
    assert_eq!(fault.word(), "refused");
    assert_eq!(session.run(Run::ONCE, LONG).unwrap_err().word(), "refused");
    let bad = [[0.0, f64::NAN], [1.0, 1.0]];
    let fault = session
        .load(Problem::Hull2, Convention::Extreme, &bad, LONG)
        .unwrap_err();
    assert!(fault.to_string().contains("finite"), "{fault}");
    session
        .load(Problem::Hull2, Convention::Extreme, &disc(5), LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();

    let mut session = start("quickhull-3d");
    let fault = session
        .load(Problem::Hull3, Convention::All, &ball(5), LONG)
        .unwrap_err();
    assert_eq!(fault.word(), "refused");
}

#[test]
fn no_points_have_an_empty_hull() {
    for (slug, problem) in [("gs", Problem::Hull2), ("gs-peel", Problem::Layers)] {
        let mut session = start(slug);
        session
            .load::<2>(problem, Convention::Extreme, &[], LONG)
            .unwrap();
        session.run(Run::ONCE, LONG).unwrap();
        assert_eq!(session.hull(LONG).unwrap().vertices(), [0_u32; 0]);
        let nothing = [PointSet::Plane(vec![]), PointSet::Plane(vec![])];
        session
            .load_sets(problem, Convention::Extreme, &nothing, LONG)
            .unwrap();
        session.run(Run::ONCE, LONG).unwrap();
        let second = session.hull_of(1, LONG).unwrap();
        assert_eq!(second.vertices(), [0_u32; 0]);
    }
}

#[test]
fn an_engine_ends_with_its_input() {
    let program = places().hullbench;
    let output = Command::new(program)
        .args(["engine", "gs"])
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(output.status.success() && output.stdout.is_empty());
}

#[test]
fn an_engine_that_is_none_is_a_usage_error() {
    assert!(find("gramham").is_none());
    assert!(matches!(find("gs"), Some(Entry::Own(_))));
    let output = Command::new(places().hullbench)
        .args(["engine", "gramham"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
}
