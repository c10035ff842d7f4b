use super::*;
use geometry_core::Exact;
use hull_verify::families_space::{self, random};

/// The hull of `points` in three parts, halved as often as can be.
fn by_halves(points: &[Point3]) -> Result<Hull3, HullError> {
    let third = points.len().div_ceil(3).max(1);
    let part = |(number, points): (usize, &[Point3])| Left {
        points: points.to_vec(),
        ids: (0..).skip(number * third).take(points.len()).collect(),
    };
    let parts = points.chunks(third).enumerate().map(part).collect();
    let forks = Forks {
        most: 4,
        least_points: 2,
    };
    hull_by_halves(parts, forks, &Exact)
}

fn assert_right(points: &[Point3], what: &str) -> Result<(), HullError> {
    let expected = crate::quickhull_3d(Points::new(points)?, &Exact, &mut Silent)?;
    assert_eq!(by_halves(points)?, expected, "{what}: {points:?}");
    Ok(())
}

#[test]
fn every_family_has_the_hull_of_the_exact_method() -> Result<(), HullError> {
    for family in families_space::all() {
        assert_right(&family.points, family.name)?;
    }
    Ok(())
}

#[test]
fn difficult_sets_have_the_hull_of_the_exact_method() -> Result<(), HullError> {
    for seed in 0..3_000 {
        assert_right(&random::difficult(seed), &format!("seed {seed}"))?;
    }
    Ok(())
}

/// Of points in general position, the parts are joined by a seam, and not by a hull of all their corners.
#[test]
fn halves_of_a_ball_are_sewn_together() -> Result<(), HullError> {
    let (near, far): (Vec<_>, Vec<_>) =
        random::ball(1, 4_000).into_iter().partition(|p| p[0] < 0.1);
    let corners = |points: Vec<Point3>, first: u32| {
        let ids = (first..).take(points.len()).collect();
        Corners::of(Left { points, ids }, &Exact)
    };
    let [near, far] = [corners(near, 0)?, corners(far, 4_000)?];
    let all = near.left.and(&far.left);
    let first = near.left.ids.len() as u32;
    let shells = [near.shell(0), far.shell(first)].map(|shell| shell.expect("not flat"));
    let (mesh, edges) = seam::joined(shells, &all, &Exact)?.expect("a seam");
    assert_eq!(edges, Edges::BentAtRims);
    assert!(mesh.is_sound());
    let points = Points::new(&all.points)?;
    let expected = surface(points, &Exact, &mut Silent)?.hull(points, &Exact);
    assert_eq!(
        Hull3::from_known_mesh(points, &mesh, edges, &Exact),
        expected
    );
    Ok(())
}

/// Where even differences of coordinates overflow, nothing is certain of a height that is not a number.
#[test]
fn differences_may_overflow() -> Result<(), HullError> {
    for seed in 0..2_000 {
        let lattice = random::on_grid(seed, 2 + seed as u32 % 4, 8 + seed as usize % 30);
        let most = lattice
            .iter()
            .flatten()
            .fold(0.0, |most: f64, &x| most.max(x));
        let huge = |p: &Point3| p.map(|x| (x / most.max(1.0) - 0.5) * 2.0 * f64::MAX);
        let points: Vec<Point3> = lattice.iter().map(huge).collect();
        assert_right(&points, &format!("seed {seed}"))?;
    }
    Ok(())
}
