use geometry_core::{Counted, Exact, Points, Silent, Tally};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::time::Instant;
fn main() {
    let n = 1_000_000;
    let mut rng = ChaCha8Rng::seed_from_u64(1996);
    let ball: Vec<[f64; 3]> =
        std::iter::repeat_with(|| [0, 1, 2].map(|_| rng.random_range(-1.0f64..1.0)))
            .filter(|p| p.iter().map(|x| x * x).sum::<f64>() < 1.0)
            .take(n)
            .collect();
    let sphere: Vec<[f64; 3]> = ball
        .iter()
        .map(|p| {
            let r = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / r)
        })
        .collect();
    let numbers: Vec<f64> = ball.iter().map(|p| p[0]).collect();
    for _ in 0..3 {
        let mut v = numbers.clone();
        let t = Instant::now();
        v.sort_unstable_by(f64::total_cmp);
        let s = t.elapsed().as_secs_f64();
        let t = Instant::now();
        let h = quickhull::quickhull_3d(Points::new(&ball).unwrap(), &Exact, &mut Silent).unwrap();
        let b = t.elapsed().as_secs_f64();
        let t = Instant::now();
        let h2 =
            quickhull::quickhull_3d(Points::new(&sphere).unwrap(), &Exact, &mut Silent).unwrap();
        let q = t.elapsed().as_secs_f64();
        println!(
            "sort {:.1} ms ball {:.1} ms ({:.1}) h={} sphere {:.1} ms ({:.1}) h={}",
            s * 1e3,
            b * 1e3,
            b / s,
            h.len(),
            q * 1e3,
            q / s,
            h2.len()
        );
    }
    for (name, p) in [("ball", &ball), ("sphere", &sphere)] {
        for m in [1000, 10000, 100000, 1000000] {
            let k = Counted::new(Exact);
            let mut t = Tally::default();
            quickhull::quickhull_3d(Points::new(&p[..m]).unwrap(), &k, &mut t).unwrap();
            let c = k.counts();
            println!(
                "{name} {m} orient {:.2} heights {:.2} visits {:.2} facets {:.2} storage {:.2}",
                c.orientations_in_space.total() as f64 / m as f64,
                c.heights.total() as f64 / m as f64,
                t.visits as f64 / m as f64,
                t.facets as f64 / (t.facets - t.drops) as f64,
                t.storage as f64 / m as f64
            );
        }
    }
}
