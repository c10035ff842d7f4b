//! Peels of known shape, and the storage that the paper promises for them.

use geometry_core::{Boundary, Exact, Layers, Points, Silent, Tally};
use hull_verify::families::{curves, grids, random};
use planar_peeling::chain_peel::chain_peel;
use planar_peeling::gs::gs;
use planar_peeling::peel::gs_peel;

fn sizes(layers: &Layers) -> Vec<usize> {
    layers.rings().iter().map(|ring| ring.len()).collect()
}

/// The kind of lattice in the paper's figure 2, and how many points each of its peels has.
#[test]
fn an_oblique_lattice_peels_in_five_rings() {
    let cells = (0..100).map(|cell| [f64::from(cell % 10), f64::from(cell / 10)]);
    let points: Vec<[f64; 2]> = cells.map(|[u, v]| [3.0 * u + v, u + 2.0 * v]).collect();
    let points = Points::new(&points).expect("finite points");
    let layers = gs_peel(points, Boundary::All, &Exact, &mut Silent).expect("exact");
    assert_eq!(sizes(&layers), [36, 28, 20, 12, 4]);
    let chains = chain_peel(points, Boundary::All, &Exact, &mut Silent).expect("exact");
    assert_eq!(chains, layers);
}

#[test]
fn nested_triangles_peel_one_by_one() {
    let points = curves::nested_triangles(100);
    let points = Points::new(&points).expect("finite points");
    for boundary in [Boundary::Extreme, Boundary::All] {
        let layers = gs_peel(points, boundary, &Exact, &mut Silent).expect("exact");
        assert_eq!(sizes(&layers), [3; 100]);
        // The largest triangle comes last in the input.
        assert!((0..300).all(|id| layers.c_ranks()[id] == 100 - id as u32 / 3));
    }
}

/// m is sufficient "if it equals the number of peels required plus the maximum number of points found to lie on any
/// one of these peels".
#[test]
fn the_label_stack_stays_within_the_promise() {
    for points in [
        random::disc(4, 2_000),
        random::on_grid(5, 12, 400),
        curves::circle(500),
        curves::nested_triangles(50),
        grids::lattice(20),
    ] {
        let points = Points::new(&points).expect("finite points");
        for boundary in [Boundary::Extreme, Boundary::All] {
            let mut tally = Tally::default();
            let hull = gs(points, boundary, &Exact, &mut tally).expect("exact");
            assert!(tally.storage <= hull.len() as u64);

            let mut tally = Tally::default();
            let layers = gs_peel(points, boundary, &Exact, &mut tally).expect("exact");
            let largest = sizes(&layers).into_iter().max().unwrap_or(0);
            assert_eq!(tally.layers, layers.len() as u64);
            assert!(tally.storage <= (layers.len() + largest) as u64);
        }
    }
}
