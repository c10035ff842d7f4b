//! Our methods over the pipe give what the library gives.

use bench_harness::counting::PointSet;
use bench_harness::engine::catalogue::{Entry, Places, find};
use bench_harness::engine::client::Session;
use bench_harness::engine::protocol::{Convention, Problem, Run};
use geometry_core::{Boundary, Method, Points, Task};
use point_sets::Spec;
use std::io::Write;
use std::num::NonZeroU32;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

const LONG: Duration = Duration::from_secs(120);
const SEED: u64 = 11;

fn places() -> Places {
    Places {
        hullbench: PathBuf::from(env!("CARGO_BIN_EXE_hullbench")),
        sources: None,
        cache: PathBuf::new(),
    }
}

fn start(slug: &str) -> Session {
    let launch = find(slug)
        .expect("a registered slug")
        .launch(&places())
        .unwrap();
    Session::start(&launch, LONG).unwrap()
}

fn disc(n: usize) -> Vec<[f64; 2]> {
    "disc".parse::<Spec>().unwrap().generate(n, SEED).unwrap()
}

fn ball(n: usize) -> Vec<[f64; 3]> {
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

/// Sets of `n` points each, no two alike.
fn discs(sets: u64, n: usize) -> Vec<Vec<[f64; 2]>> {
    let spec = "disc".parse::<Spec>().unwrap();
    let set = |number| spec.generate(n, SEED + number).unwrap();
    (0..sets).map(set).collect()
}

#[test]
fn a_batch_gives_the_hull_of_every_set() {
    let discs = discs(40, 60);
    let sets: Vec<_> = discs.iter().cloned().map(PointSet::Plane).collect();
    let mut session = start("gs");
    session
        .load_sets(Problem::Hull2, Convention::Extreme, &sets, LONG)
        .unwrap();
    assert_eq!(session.hull_of(3, LONG).unwrap_err().word(), "refused");
    session.run(Run::ONCE, LONG).unwrap();
    for (number, points) in (0..).zip(&discs) {
        let answer = session.hull_of(number, LONG).unwrap();
        let hull = answer.hull2(Points::new(points).unwrap());
        assert_eq!(
            hull,
            hullkit::convex_hull_2d(points).ok(),
            "set {number}, seed {SEED}"
        );
    }
    assert_eq!(session.hull(LONG), session.hull_of(0, LONG));
    assert_eq!(session.hull_of(40, LONG).unwrap_err().word(), "refused");
    // One set again: nothing of the batch is left.
    session
        .load(Problem::Hull2, Convention::Extreme, &discs[7], LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    let hull = session.hull(LONG).unwrap();
    let hull = hull.hull2(Points::new(&discs[7]).unwrap());
    assert_eq!(hull, hullkit::convex_hull_2d(&discs[7]).ok());
    assert_eq!(session.hull_of(1, LONG).unwrap_err().word(), "refused");
}

#[test]
fn a_batch_in_space_gives_the_hull_of_every_set() {
    let spec = "ball".parse::<Spec>().unwrap();
    let balls = (0..5).map(|number| spec.generate3(50, SEED + number).unwrap());
    let balls: Vec<_> = balls.collect();
    let sets: Vec<_> = balls.iter().cloned().map(PointSet::Space).collect();
    let mut session = start("quickhull-3d");
    session
        .load_sets(Problem::Hull3, Convention::Extreme, &sets, LONG)
        .unwrap();
    session.run(Run::ONCE, LONG).unwrap();
    for (number, points) in (0..).zip(&balls) {
        let hull = session.hull_of(number, LONG).unwrap();
        let hull = hull.hull3(Points::new(points).unwrap());
        assert_eq!(hull, hullkit::convex_hull_3d(points).ok(), "set {number}");
    }
}

#[test]
fn a_sample_goes_through_all_sets() {
    for (slug, problem) in [
        ("gs", Problem::Hull2),
        ("sort", Problem::Hull2),
        ("pass", Problem::Hull2),
    ] {
        let mut session = start(slug);
        let mut least = |sets: u64, inner: u32| {
            let sets: Vec<_> = discs(sets, 500).into_iter().map(PointSet::Plane).collect();
            session
                .load_sets(problem, Convention::Extreme, &sets, LONG)
                .unwrap();
            let samples = NonZeroU32::new(20).unwrap();
            let inner = NonZeroU32::new(inner).unwrap();
            let timed = session.run(Run { samples, inner }, LONG).unwrap();
            timed.nanoseconds.into_iter().min().unwrap()
        };
        let (one, sets, passes) = (least(1, 4), least(100, 4), least(100, 40));
        assert!(
            sets > 10 * one,
            "{slug}: {sets} ns for 100 sets, {one} ns for 1"
        );
        assert!(
            passes > 3 * sets,
            "{slug}: {passes} ns for 40 passes, {sets} ns for 4"
        );
    }
}

#[test]
fn the_counts_of_a_batch_are_sums() {
    let discs = discs(6, 80);
    let mut session = start("gs");
    let mut counters = |sets: &[Vec<[f64; 2]>]| {
        let sets: Vec<_> = sets.iter().cloned().map(PointSet::Plane).collect();
        session
            .load_sets(Problem::Hull2, Convention::Extreme, &sets, LONG)
            .unwrap();
        session.run(Run::ONCE, LONG).unwrap();
        let mut counters = session.counters(LONG).unwrap();
        counters.remove("peak_bytes");
        counters
    };
    let mut sums = std::collections::BTreeMap::new();
    for set in discs.chunks(1) {
        for (name, count) in counters(set) {
            *sums.entry(name).or_insert(0) += count;
        }
    }
    assert_eq!(counters(&discs), sums);
    assert!(sums["visits"] > 6 * 80);
}

#[test]
fn sets_that_do_not_fit_together_are_no_batch() {
    let [five, six] = [5, 6].map(|n| PointSet::Plane(disc(n)));
    let in_space = PointSet::Space(ball(5));
    let mut session = start("gs");
    for sets in [vec![], vec![five.clone(), six], vec![five, in_space]] {
        let fault = session
            .load_sets(Problem::Hull2, Convention::Extreme, &sets, LONG)
            .unwrap_err();
        assert_eq!(fault.word(), "refused", "{fault}");
        assert_eq!(session.hull(LONG).unwrap_err().word(), "refused");
    }
    // One bad set spoils the batch.
    let mut sets = discs(3, 10);
    sets[2][9][1] = f64::INFINITY;
    let sets: Vec<_> = sets.into_iter().map(PointSet::Plane).collect();
    let fault = session
        .load_sets(Problem::Hull2, Convention::Extreme, &sets, LONG)
        .unwrap_err();
    assert!(fault.to_string().contains("finite"), "{fault}");
}

#[test]
fn a_conversation_written_by_hand_needs_no_sets() {
    let mut child = Command::new(places().hullbench)
        .args(["engine", "gs"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut said = br#"load {"task":"hull2","n":3,"dimension":2,"boundary":"extreme"}"#.to_vec();
    said.push(b'\n');
    for x in [0.0_f64, 0.0, 1.0, 0.0, 0.0, 1.0] {
        said.extend(x.to_le_bytes());
    }
    said.extend(b"run {\"samples\":1,\"inner\":2}\nhull\nquit\n");
    child.stdin.take().unwrap().write_all(&said).unwrap();
    let output = child.wait_with_output().unwrap().stdout;
    let lines: Vec<_> = output.splitn(4, |&byte| byte == b'\n').collect();
    assert_eq!(lines[0], br#"{"loaded":3}"#);
    assert_eq!(lines[2], br#"{"kind":"cycle","lengths":1,"indices":3}"#);
    let arrays = [3_u32, 0, 1, 2].map(u32::to_le_bytes);
    assert_eq!(lines[3], arrays.as_flattened());
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
