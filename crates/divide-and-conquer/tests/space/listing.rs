//! Day's spiral over the facets (section 4), against a plain traversal and the hull.

use crate::sets::{ball, cone, fan, lattice, sphere};
use divide_and_conquer::preparata_hong_3d;
use divide_and_conquer::preparata_hong_3d::{Listings, listings};
use geometry_core::{Exact, Points, Silent};

fn sorted(facets: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let first = |mut corners: [u32; 3]| {
        let smallest = (0..3).min_by_key(|&i| corners[i]).expect("three");
        corners.rotate_left(smallest);
        corners
    };
    let mut sorted: Vec<[u32; 3]> = facets.iter().copied().map(first).collect();
    sorted.sort_unstable();
    sorted
}

#[test]
fn the_spiral_lists_every_facet_once() {
    for set in [sphere(1, 500), ball(2, 500), fan(50, 0.0), cone(50)] {
        let points = Points::new(&set).expect("finite");
        let listings = listings(points, &Exact).expect("an exact kernel");
        let listed = sorted(&listings.spiral);
        assert_eq!(listed, sorted(&listings.by_number));
        assert!(listed.windows(2).all(|pair| pair[0] != pair[1]));
        assert!((1..=listed.len()).contains(&listings.deepest));
        let hull = preparata_hong_3d(points, &Exact, &mut Silent).expect("an exact kernel");
        // FAN has facets of four corners, which are listed as two triangles.
        if hull.facets().all(|facet| facet.len() == 3) {
            assert_eq!(listed, hull.triangles().collect::<Vec<_>>());
        } else {
            assert_eq!(listed.len(), 2 * hull.len() - 4);
        }
    }
}

#[test]
fn coplanar_facets_are_listed_as_triangles_and_flat_sets_not_at_all() {
    let cube = lattice(3);
    let listings_of = |set: &[[f64; 3]]| {
        listings(Points::new(set).expect("finite"), &Exact).expect("an exact kernel")
    };
    let cube = listings_of(&cube);
    assert!(cube.spiral.len() >= 12);
    assert_eq!(sorted(&cube.spiral), sorted(&cube.by_number));
    let plane: Vec<_> = lattice(4).into_iter().map(|p| [p[0], p[1], 0.0]).collect();
    assert_eq!(listings_of(&plane), Listings::default());
}
