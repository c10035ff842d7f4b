//! The methods against the definition, on small sets full of degeneracies.

use geometry_core::{Boundary, Exact, Hull2, Kernel2, Layers, Points, Sign, Task};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The hull by its definition, in O(n³).
fn hull_by_definition(points: &[[f64; 2]], ids: &[u32], boundary: Boundary) -> Hull2 {
    let at = |id: u32| points[id as usize];
    let mut distinct: Vec<u32> = ids.to_vec();
    distinct.sort_by(|&a, &b| at(a).partial_cmp(&at(b)).unwrap().then(a.cmp(&b)));
    distinct.dedup_by(|a, b| at(*a) == at(*b));
    let view = Points::new(points).unwrap();
    let orient = |a: u32, b: u32, c: u32| Exact.orient(at(a), at(b), at(c));
    let (Some(&first), Some(&last)) = (distinct.first(), distinct.last()) else {
        return Hull2::Empty;
    };
    if distinct
        .iter()
        .all(|&p| orient(first, last, p) == Sign::Zero)
    {
        return Hull2::of_collinear(view, distinct, boundary, &Exact);
    }
    // The successor of a vertex: nothing to the right, and of those in line the nearest (or the furthest).
    let between = |a: u32, b: u32, p: u32| {
        orient(a, b, p).is_zero()
            && Exact.compare_along(at(a), at(b), at(a), at(p)).is_lt()
            && Exact.compare_along(at(a), at(b), at(p), at(b)).is_lt()
    };
    let is_edge = |a: u32, b: u32| {
        a != b
            && distinct.iter().all(|&p| {
                let sign = orient(a, b, p);
                let beyond = sign.is_zero() && p != a && p != b && !between(a, b, p);
                match boundary {
                    Boundary::Extreme => !sign.is_negative() && !beyond,
                    Boundary::All => !sign.is_negative() && !between(a, b, p),
                }
            })
    };
    let mut cycle = vec![first];
    loop {
        let from = *cycle.last().unwrap();
        let to = *distinct.iter().find(|&&to| is_edge(from, to)).unwrap();
        if to == first {
            return Hull2::from_cycle(view, cycle);
        }
        cycle.push(to);
    }
}

fn layers_by_definition(points: &[[f64; 2]], boundary: Boundary) -> Layers {
    let mut stages = vec![0_u32; points.len()];
    let mut rings = Vec::new();
    loop {
        let left: Vec<u32> = (0..points.len() as u32)
            .filter(|&id| stages[id as usize] == 0)
            .collect();
        if left.is_empty() {
            return Layers::new(rings, stages);
        }
        let ring = hull_by_definition(points, &left, boundary);
        for &id in &left {
            let copies = |v: &u32| points[*v as usize] == points[id as usize];
            if ring.vertices().iter().any(copies) {
                stages[id as usize] = rings.len() as u32 + 1;
            }
        }
        rings.push(ring);
    }
}

fn check(points: &[[f64; 2]]) {
    let view = Points::new(points).unwrap();
    let ids: Vec<u32> = view.ids().collect();
    for boundary in [Boundary::Extreme, Boundary::All] {
        let hull = hull_by_definition(points, &ids, boundary);
        let layers = layers_by_definition(points, boundary);
        for method in planar_peeling::METHODS {
            match method.task {
                Task::PlanarHull(run) => {
                    let found = (run.exact)(view, boundary).unwrap();
                    assert_eq!(found, hull, "{} {boundary:?} {points:?}", method.slug);
                }
                Task::PlanarLayers(run) => {
                    let found = (run.exact)(view, boundary).unwrap();
                    assert_eq!(found, layers, "{} {boundary:?} {points:?}", method.slug);
                }
                _ => unreachable!("a planar family"),
            }
        }
    }
}

#[test]
fn every_set_of_up_to_five_points_of_a_lattice() {
    for n in 0..=4_u32 {
        for code in 0..9_u32.pow(n) {
            let points: Vec<[f64; 2]> = (0..n)
                .map(|k| code / 9_u32.pow(k) % 9)
                .map(|cell| [f64::from(cell % 3), f64::from(cell / 3)])
                .collect();
            check(&points);
        }
    }
}

#[test]
fn random_points_of_small_lattices() {
    let mut rng = ChaCha8Rng::seed_from_u64(1979);
    for round in 0..3000 {
        let n = rng.random_range(0..40);
        let side = rng.random_range(1..12);
        let scale = [1.0, 1e300, 1e-310, 0.1][round % 4];
        let points: Vec<[f64; 2]> = (0..n)
            .map(|_| [0, 1].map(|_| f64::from(rng.random_range(0..side)) * scale))
            .collect();
        check(&points);
    }
}
