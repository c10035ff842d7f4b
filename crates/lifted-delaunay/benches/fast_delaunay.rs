//! scratch
#![allow(clippy::print_stdout)]
use geometry_core::{Points, Triangulation};
use lifted_delaunay::fast_delaunay;
use point_sets::Spec;
use std::hint::black_box;

fn triangulated(points: &[[f64; 2]]) -> Triangulation {
    fast_delaunay(Points::new(points).expect("finite")).expect("exact")
}

fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/self/schedstat").expect("linux");
    s.split(' ').next().expect("x").parse::<f64>().expect("ns") / 1e6
}

fn main() {
    let args: Vec<String> = std::env::args().filter(|a| !a.starts_with("--")).collect();
    let set = args.get(1).map_or("disc", |s| s.as_str());
    let n: usize = args.get(2).map_or(1_000_000, |s| s.parse().expect("n"));
    let reps: usize = args.get(3).map_or(5, |s| s.parse().expect("reps"));
    let spec: Spec = set.parse().expect("set");
    let points = spec.generate(n, 1).expect("points");
    if let Some(file) = args.get(4) {
        let bytes: Vec<u8> = points
            .as_flattened()
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect();
        std::fs::write(file, bytes).expect("write");
    }
    let t = triangulated(&points);
    if std::env::var("CERTIFY").is_ok() {
        match hull_verify::check::delaunay(&points, &t) {
            Ok(c) => println!("{c:?}"),
            Err(e) => println!("{} findings: {:?}", e.len(), &e[0]),
        }
    }
    let mut numbers: Vec<f64> = points.iter().map(|p| p[0]).collect();
    let s = cpu();
    numbers.sort_unstable_by(f64::total_cmp);
    let sort = cpu() - s;
    let mut times: Vec<f64> = (0..reps)
        .map(|_| {
            let s = cpu();
            black_box(triangulated(&points));
            cpu() - s
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!(
        "{set} n={n} min {:.1} med {:.1} ms; sort {sort:.1}",
        times[0],
        times[reps / 2]
    );
}
