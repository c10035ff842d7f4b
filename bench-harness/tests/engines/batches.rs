//! Many sets in one load: a hull for each, and samples that go through all of them.

use super::own::{LONG, SEED, ball, disc, places, start};
use bench_harness::counting::PointSet;
use bench_harness::engine::protocol::{Convention, Problem, Run};
use geometry_core::Points;
use point_sets::Spec;
use std::io::Write;
use std::num::NonZeroU32;
use std::process::{Command, Stdio};

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
