//! The parallel method gives what the sequential one does, on sets of several parts and with any number of threads.

use geometry_core::{Boundary, Hull2};
use hull_verify::families::{curves, grids, random};
use quickhull::{convex_hull, convex_hull_parallel};
use rayon::ThreadPoolBuilder;

#[test]
fn any_number_of_threads_gives_the_same_hull() {
    let sets = [
        random::disc(7, 200_000),
        grids::lattice(400),
        curves::circle(100_000),
        random::on_grid(8, 1_000_000, 150_000),
    ];
    for points in &sets {
        for boundary in [Boundary::Extreme, Boundary::All] {
            let expected = convex_hull(points, boundary).expect("finite points");
            let hull_by = |threads: usize| -> Hull2 {
                let pool = ThreadPoolBuilder::new().num_threads(threads).build();
                let pool = pool.expect("a few threads can be had");
                pool.install(|| convex_hull_parallel(points, boundary).expect("finite points"))
            };
            for threads in [1, 2, 3] {
                assert_eq!(hull_by(threads), expected, "{threads} threads");
            }
        }
    }
}
