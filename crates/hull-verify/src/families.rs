//! The degenerate point sets of the plane, each named: what a hull algorithm must take as ordinary input.
//!
//! [`all`] lists one or more sets of every family, small enough for the [oracle](crate::oracle); [`large`] lists
//! some at sizes that only the [certificate](crate::check) can judge. The functions in the submodules make them at
//! any size.
//!
//! | module | families |
//! |---|---|
//! | [`few`] | none, one, two points; copies; triangles with copies |
//! | [`lines`] | collinear points, exactly and after rounding; points an ulp off a line |
//! | [`grids`] | lattices, outlines, columns: many collinear triples and equal coordinates |
//! | [`curves`] | circles, parabolas, nested triangles: many vertices, or many layers |
//! | [`magnitudes`] | the ends of the range of `f64`, and both in one set |
//! | [`random`] | random points, on small grids and in a disc |

pub mod curves;
pub mod few;
pub mod grids;
pub mod lines;
pub mod magnitudes;
pub mod random;

use geometry_core::Point2;

/// A named point set.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// What it is, in lower case with hyphens.
    pub name: &'static str,
    /// The points, in the order in which they are given to a method first.
    pub points: Vec<Point2>,
}

/// Every family of the plane, at sizes up to some seventy points. The same list at every call.
///
/// ```
/// use hull_verify::families;
/// let families = families::all();
/// assert!(families.len() > 50);
/// assert!(families.iter().all(|family| family.points.len() <= 100));
/// ```
pub fn all() -> Vec<Family> {
    let family = |name, points| Family { name, points };
    vec![
        family("empty", few::empty()),
        family("one", few::one()),
        family("two", few::two()),
        family("two-upright", vec![[1.0, 5.0], [1.0, -5.0]]),
        family("copies", few::copies(7)),
        family("two-places", few::two_places(5)),
        family("triangle", few::triangle()),
        family(
            "triangle-clockwise",
            few::triangle().into_iter().rev().collect(),
        ),
        family(
            "triangle-with-copied-corners",
            few::triangle_with_copied_corners(6),
        ),
        family(
            "square-with-copied-centre",
            few::square_with_copied_centre(9),
        ),
        family("horizontal", lines::horizontal(9)),
        family("vertical", lines::vertical(9)),
        family("diagonal", lines::diagonal(9)),
        family("falling", lines::falling(9)),
        family("steep", lines::steep(9)),
        family("tenths", lines::tenths(40)),
        family("tenths-on-one-line", lines::tenths_on_one_line(20)),
        family("thirds", lines::thirds(30)),
        family("ulp-off", lines::ulp_off(21)),
        family("ulp-off-one", lines::one_ulp_off(17)),
        family("line-and-apex", lines::line_and_apex(12)),
        family("line-and-two-apexes", lines::line_and_two_apexes(12)),
        family("collinear-copies", few::twice(lines::diagonal(8))),
        family("classroom", lines::classroom(6)),
        family("lattice-2", grids::lattice(2)),
        family("lattice-3", grids::lattice(3)),
        family("lattice-7", grids::lattice(7)),
        family("lattice-twice", few::twice(grids::lattice(5))),
        family("lattice-of-tenths", grids::lattice_of_tenths(6)),
        family("sheared-lattice", grids::sheared_lattice(6)),
        family("diamond", grids::diamond(4)),
        family("square-outline", grids::square_outline(8)),
        family("square-outline-twice", few::twice(grids::square_outline(5))),
        family("triangle-outline", grids::triangle_outline(9)),
        family("columns", grids::columns(4, 12)),
        family("two-columns", grids::columns(2, 15)),
        family("rows", grids::rows(4, 12)),
        family("staircase", grids::staircase(14)),
        family("cross", grids::cross(7)),
        family("circle", curves::circle(48)),
        family("circle-twice", few::twice(curves::circle(17))),
        family("integer-circle", curves::integer_circle()),
        family("integer-circle-and-axes", curves::integer_circle_and_axes()),
        family("parabola", curves::parabola(25)),
        family("lying-parabola", curves::lying_parabola(25)),
        family("quickhull-killer", curves::geometric_parabola(40)),
        family("nested-triangles", curves::nested_triangles(12)),
        family("nested-squares", curves::nested_squares(9)),
        family("spiral", curves::spiral(40)),
        family("huge", magnitudes::huge()),
        family("tiny", magnitudes::tiny()),
        family("subnormal", magnitudes::subnormal()),
        family("subnormal-lattice", magnitudes::subnormal_lattice(5)),
        family("whole-range", magnitudes::whole_range()),
        family("mixed-exponents", magnitudes::mixed_exponents(7, 30)),
        family("signed-zeros", magnitudes::signed_zeros()),
        family("far-from-origin", magnitudes::far_from_origin(6)),
        family("grid-of-3", random::on_grid(11, 3, 30)),
        family("grid-of-5", random::on_grid(12, 5, 40)),
        family("grid-of-20", random::on_grid(13, 20, 60)),
        family("disc", random::disc(14, 60)),
        family("disc-of-singles", random::disc_of_singles(15, 50)),
        family("square", random::square(16, 60)),
        family("near-a-line", random::near_a_line(17, 40)),
    ]
}

/// Families at sizes up to three thousand points. The same list at every call.
pub fn large() -> Vec<Family> {
    let family = |name, points| Family { name, points };
    vec![
        family("large-copies", few::copies(3000)),
        family("large-horizontal", lines::horizontal(3000)),
        family("large-vertical", lines::vertical(3000)),
        family("large-tenths", lines::tenths(1000)),
        family("large-lattice", grids::lattice(40)),
        family("large-square-outline", grids::square_outline(500)),
        family("large-columns", grids::columns(3, 700)),
        family("large-circle", curves::circle(600)),
        family("large-parabola", curves::parabola(300)),
        family("large-quickhull-killer", curves::geometric_parabola(500)),
        family("large-nested-triangles", curves::nested_triangles(300)),
        family("large-spiral", curves::spiral(1000)),
        family(
            "large-mixed-exponents",
            magnitudes::mixed_exponents(18, 300),
        ),
        family("large-grid-of-20", random::on_grid(19, 20, 3000)),
        family("large-disc", random::disc(20, 3000)),
        family("large-square", random::square(21, 3000)),
        family("large-near-a-line", random::near_a_line(22, 1000)),
    ]
}
