//! What pivoting asks, counted against the formula in its header.

use geometry_core::dimension::AffineBasis;
use geometry_core::{Counted, Exact, Hull3, Point3, Points, Silent, Tally};
use hull_verify::families_space::{grids::lattice, random::ball, round::sphere};

/// The hull, and the orientations in space that were asked after the dimension of the set was known.
fn counted(points: &[Point3]) -> (Hull3, u64, Tally) {
    let view = Points::new(points).expect("finite points");
    let setting_up = Counted::new(Exact);
    AffineBasis::of(view, &setting_up);
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let hull = gift_wrap::pivot_wrap(view, &kernel, &mut tally).expect("an exact kernel");
    let [all, before] = [&kernel, &setting_up].map(|k| k.counts().orientations_in_space.total());
    (hull, all - before, tally)
}

#[test]
fn every_facet_asks_all_points_but_three() {
    for points in [ball(1, 50), ball(2, 1_000), sphere(3, 50), sphere(4, 300)] {
        let (hull, orientations, tally) = counted(&points);
        let (n, h) = (points.len() as u64, hull.len() as u64);
        assert_eq!(orientations, (2 * h - 4) * (n - 3));
        assert_eq!(tally.visits, orientations);
        assert_eq!((tally.lines, tally.facets), (2 * h - 4, 2 * h - 4));
    }
}

/// The facets that count are the true ones: six for a grid, however many points lie in each.
#[test]
fn coplanar_points_cost_no_more_passes() {
    let points = lattice(8);
    let (hull, _, tally) = counted(&points);
    assert_eq!(hull.facets().count(), 6);
    assert_eq!(tally.lines, 6);
    assert!(tally.visits <= 6 * (points.len() as u64 - 3));
}

#[test]
fn a_flat_set_is_not_wrapped() {
    let flat: Vec<Point3> = lattice(3)
        .into_iter()
        .map(|[x, y, _]| [x, y, x + y])
        .collect();
    let view = Points::new(&flat).expect("finite points");
    let mut tally = Tally::default();
    let hull = gift_wrap::pivot_wrap(view, &Exact, &mut tally);
    assert!(matches!(hull, Ok(Hull3::Planar(corners)) if corners.len() == 4));
    assert_eq!(tally, Tally::default());
    assert_eq!(
        gift_wrap::pivot_wrap(view, &Exact, &mut Silent),
        gift_wrap::nathan(view, &Exact, &mut Silent)
    );
}
