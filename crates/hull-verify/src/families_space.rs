//! The degenerate point sets of space, each named: what a hull algorithm must take as ordinary input.
//!
//! [`all`] lists one or more sets of every family, small enough for the [oracle](crate::oracle); [`large`] lists some at
//! sizes that only the [certificate](crate::check) can judge. The functions in the submodules make them at any size.
//!
//! | module | families |
//! |---|---|
//! | [`few`] | none, one, two points; copies; points on one line; a tetrahedron |
//! | [`planes`] | points in one plane, in two, and an ulp off one |
//! | [`grids`] | lattices and polyhedra with points on their facets and edges |
//! | [`round`] | spheres, prisms, cones, curves: many vertices, facets of many corners |
//! | [`magnitudes`] | the ends of the range of `f64`, and both in one set |
//! | [`random`] | random points, on small grids, in a ball, near a plane |

pub mod few;
pub mod grids;
pub mod magnitudes;
pub mod planes;
pub mod random;
pub mod round;

use crate::families;
use geometry_core::Point3;

/// A named point set in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Family3 {
    /// What it is, in lower case with hyphens.
    pub name: &'static str,
    /// The points, in the order in which they are given to a method first.
    pub points: Vec<Point3>,
}

fn family(name: &'static str, points: Vec<Point3>) -> Family3 {
    Family3 { name, points }
}

/// Every family of space, at sizes up to some hundred points. The same list at every call.
///
/// ```
/// use hull_verify::families_space;
/// let families = families_space::all();
/// assert!(families.len() > 70);
/// assert!(families.iter().all(|family| family.points.len() <= 130));
/// ```
pub fn all() -> Vec<Family3> {
    let mut families = flat();
    families.extend(with_planes());
    families.extend(solid());
    families.extend(awkward_numbers());
    families
}

/// Dimension two at most.
fn flat() -> Vec<Family3> {
    let mut families = vec![
        family("empty", few::empty()),
        family("one", few::one()),
        family("two", few::two()),
        family("copies", few::copies(7)),
        family("two-places", few::two().repeat(5)),
        family("line-x", few::line(9, [1.0, 0.0, 0.0])),
        family("line-y", few::line(9, [0.0, -2.0, 0.0])),
        family("line-z", few::line(9, [0.0, 0.0, 3.0])),
        family("line-oblique", few::line(9, [1.0, -2.0, 3.0])),
        family("line-of-tenths", few::line(9, [0.1, 0.2, -0.4])),
        family("line-twice", few::twice(few::line(6, [1.0, 1.0, 1.0]))),
        family("triangle", few::triangle()),
        family("triangle-twice", few::twice(few::triangle())),
    ];
    let outline = families::grids::square_outline(3);
    let grid = families::grids::lattice(4);
    let disc = families::random::on_grid(21, 9, 30);
    for (name, plane) in planes::PLANES {
        families.push(family(name, planes::in_plane(&outline, plane)));
        families.push(family(name, planes::in_plane(&grid, plane)));
        families.push(family(name, planes::in_plane(&disc, plane)));
    }
    families
}

/// Dimension three, mostly in one plane or two.
fn with_planes() -> Vec<Family3> {
    let mut families = vec![
        family("plane-of-tenths", planes::tenths(5)),
        family("plane-ulp-off", planes::ulp_off(5)),
        family("plane-one-ulp-off", planes::one_ulp_off(5)),
    ];
    for (_, plane) in planes::PLANES {
        families.push(family("grid-and-apex", planes::grid_and_apex(4, plane)));
        families.push(family("two-grids", planes::two_grids(4, plane)));
    }
    families
}

fn solid() -> Vec<Family3> {
    vec![
        family("tetrahedron", few::tetrahedron()),
        family("tetrahedron-copies", few::tetrahedron_with_copies(4)),
        family("cube", grids::cube()),
        family("cube-twice", few::twice(grids::cube())),
        family("tilted-box", grids::tilted_box()),
        family("lattice-3", grids::lattice(3)),
        family("lattice-4", grids::lattice(4)),
        family("lattice-3-twice", few::twice(grids::lattice(3))),
        family("lattice-of-tenths", grids::lattice_of_tenths(4)),
        family("sheared-lattice", grids::sheared_lattice(3)),
        family("cube-surface", grids::cube_surface(4)),
        family("octahedron", grids::octahedron(3)),
        family("octahedron-midpoints", grids::octahedron_with_midpoints()),
        family("jack", grids::jack(3)),
        family("four-columns", grids::four_columns(7)),
        family("prism", round::prism()),
        family("rounded-prism", round::rounded_prism(13)),
        family("antiprism", round::antiprism(11)),
        family("cone", round::cone(24)),
        family("circle-and-axis", round::circle_and_axis()),
        family("moment-curve", round::moment_curve(17)),
        family("helix", round::helix(20)),
        family("paraboloid", round::paraboloid(6)),
        family("integer-sphere", round::integer_sphere()),
        family("sphere", round::sphere(22, 40)),
        family("shells", round::shells(23, 20)),
        family("drum", round::drum(24, 40)),
        family("grid-of-2", random::on_grid(25, 2, 12)),
        family("grid-of-3", random::on_grid(26, 3, 30)),
        family("grid-of-5", random::on_grid(27, 5, 40)),
        family("grid-of-20", random::on_grid(28, 20, 40)),
        family("cube-random", random::cube(29, 50)),
        family("ball", random::ball(30, 50)),
        family("ball-of-singles", random::ball_of_singles(31, 50)),
    ]
}

fn awkward_numbers() -> Vec<Family3> {
    vec![
        family("near-a-plane", random::near_a_plane(32, 30)),
        family("near-a-line", random::near_a_line(33, 30)),
        family("huge", magnitudes::huge()),
        family("tiny", magnitudes::tiny()),
        family("subnormal-lattice", magnitudes::subnormal_lattice()),
        family("whole-range", magnitudes::whole_range()),
        family("mixed-exponents", magnitudes::mixed_exponents(34, 16)),
        family("signed-zeros", magnitudes::signed_zeros()),
        family("far-from-origin", magnitudes::far_from_origin()),
        family("needle", magnitudes::needle(36, 30)),
        family("cube-of-1e300", magnitudes::scaled(grids::cube(), 997)),
        family(
            "lattice-of-1e-300",
            magnitudes::scaled(grids::lattice(3), -997),
        ),
    ]
}

/// Families at sizes up to eight thousand points. The same list at every call.
pub fn large() -> Vec<Family3> {
    let oblique = planes::PLANES[4].1;
    vec![
        family("large-copies", few::copies(2000)),
        family("large-line", few::line(2000, [1.0, -2.0, 3.0])),
        family(
            "large-plane",
            planes::in_plane(&families::grids::lattice(40), oblique),
        ),
        family("large-grid-and-apex", planes::grid_and_apex(20, oblique)),
        family("large-two-grids", planes::two_grids(15, oblique)),
        family("large-lattice", grids::lattice(20)),
        family("large-cube-surface", grids::cube_surface(12)),
        family("large-octahedron", grids::octahedron(8)),
        family("large-four-columns", grids::four_columns(250)),
        family("large-rounded-prism", round::rounded_prism(200)),
        family("large-antiprism", round::antiprism(200)),
        family("large-cone", round::cone(400)),
        family("large-moment-curve", round::moment_curve(60)),
        family("large-paraboloid", round::paraboloid(20)),
        family("large-sphere", round::sphere(37, 1000)),
        family("large-shells", round::shells(38, 300)),
        family("large-drum", round::drum(39, 1000)),
        family("large-grid-of-20", random::on_grid(40, 20, 3000)),
        family("large-cube", random::cube(41, 3000)),
        family("large-ball", random::ball(42, 3000)),
        family("large-near-a-plane", random::near_a_plane(43, 300)),
        family("large-mixed-exponents", magnitudes::mixed_exponents(44, 60)),
        family("large-needle", magnitudes::needle(45, 1000)),
    ]
}
