//! Scratch.
use geometry_core::mesh::TriMesh;
use geometry_core::*;
#[test]
fn agree() {
    let _ = TriMesh::new();
    let mut sets: Vec<Vec<[f64; 3]>> = vec![];
    sets.push(
        (0..125)
            .map(|i| [i / 25, i / 5 % 5, i % 5].map(f64::from))
            .collect(),
    );
    sets.push(
        (0..125)
            .map(|i| [i * 7 % 5, i / 25, i / 5 % 5].map(f64::from))
            .chain((0..125).map(|i| [i / 25, i / 5 % 5, i % 5].map(f64::from)))
            .collect(),
    );
    let mut s = 1u64;
    let mut r = move || {
        s = s
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (s >> 33)
    };
    for n in [4, 5, 6, 7, 8, 10, 20, 50, 200] {
        for m in [2, 3, 4, 6, 1000000] {
            for _ in 0..30 {
                sets.push(
                    (0..n)
                        .map(|_| [(r() % m) as f64, (r() % m) as f64, (r() % m) as f64])
                        .collect(),
                );
            }
        }
    }
    for set in &sets {
        let p = Points::new(set).unwrap();
        let a = incremental::incremental_3d(p, &Exact, &mut Silent).unwrap();
        let b = incremental::incremental_conflict(p, &Exact, &mut Silent).unwrap();
        assert_eq!(a, b, "{set:?}");
        // brute force for small
        if set.len() <= 20 {
            if let Hull3::Solid(_) = a {
                for f in a.facets() {
                    for id in p.ids() {
                        assert!(
                            !Exact
                                .orient3(p[f[0]], p[f[1]], p[f[2]], p[id])
                                .is_positive()
                        );
                    }
                }
                for id in p.ids() {
                    let on = a
                        .facets()
                        .filter(|f| Exact.orient3(p[f[0]], p[f[1]], p[f[2]], p[id]).is_zero())
                        .count();
                    if on >= 3 {
                        assert!(a.vertices().iter().any(|&v| p[v] == p[id] && v <= id));
                    }
                }
            }
        }
    }
}
