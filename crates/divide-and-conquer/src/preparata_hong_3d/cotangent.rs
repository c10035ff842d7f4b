//! Day's own arithmetic: cotangents of angles between facets, in a chosen number format.
//!
//! Day (section 3.5) compares two candidates by the cotangents of the angles that their facets make with the facet
//! behind: the smaller the cotangent, the larger the angle. Where its magnitude exceeds a bound, `eps2`, the angle is
//! taken for 0 or a half-turn, and which of them is read from the sign of the numerator:
//!
//! ```text
//!               v                    n = unit((v - a) × (b - a))    normal to the candidate's facet
//!              /                     f = unit(n × (b - a))          in it, away from v
//!             / angle                cot = - (c - b) · f / (c - b) · n
//!     c ---- ab                      the bridge ab, seen along it
//! ```
//!
//! Day reports that the hull was "consistently found to be correct" in the 80-bit format with eps2 = 10¹⁶, and that
//! shorter formats, unless eps2 was reduced, led to "pointer dereferencing zero, incorrect hulls, and infinite looping".
//! [`day_cotangent`] makes that an experiment: the same merge, with these comparisons in any [`Format`].
//!
//! As Day has it: the split into multiples of four points, tetrahedra at the bottom by the sign of a triple product, and
//! `onleft` for the shadows, all in the format. Departures: axes are renamed as in [`preparata_hong_3d`]; the reference
//! point behind the first bridge, of which he only says that it lies "immediately behind" it, is vertically below its
//! end in the first half by the length of the bridge's shadow; a search does not look beyond an edge of arrival; and
//! what would be an endless loop or a dangling pointer is found out and reported.
//!
//! On points uniform in a cube, the report holds: of 20 sets of 100 points all come out right in 64 bits with eps2 = 10¹⁶,
//! but hardly any in 53 bits and none in 24, which need 10¹³ and 10⁴. With p bits, an eps2 beyond about 2ᵖ lets rounding
//! noise decide between an angle of 0 and a half-turn; one that is too small takes different angles for equal.
//!
//! [`preparata_hong_3d`]: super

use super::edges::{Dart, Half};
use super::faces::by_spiral;
use super::questions::{Bridge, Questions};
use super::surface::{Fault, Surface};
use super::{Order, Resumed, preparata_hong_3d};
use geometry_core::hull3::Solid;
use geometry_core::tolerance::formats::Format;
use geometry_core::{Exact, Hull3, HullError, Point3, Points, Sign, Silent};
use std::marker::PhantomData;
use std::ops::Range;

/// How a run with rounded cotangents ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Outcome {
    /// With the hull.
    Right,
    /// With a closed surface that is not the hull.
    WrongHull,
    /// Not at all, if it were not stopped.
    NotTerminating,
    /// With facets that do not fit together.
    Dangling,
}

/// Why there are no facets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Failure {
    /// A wrap took twenty times as many steps as there can be facets.
    NotTerminating,
    /// The facets of a wrap did not fit the hulls it joined.
    Dangling,
    /// There are fewer than four points.
    TooFewPoints,
}

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::Endless => Failure::NotTerminating,
            Fault::Tangled => Failure::Dangling,
        }
    }
}

/// The facets that Day's program finds when it computes in the format `F` with this `eps2`, as triangles
/// anticlockwise seen from outside. They need not be those of the hull.
///
/// The points must be in general position, as Day's random ones. They are rounded to `F` first. A number of points
/// that is no multiple of four is made one by points inside, numbered from `points.len()` on: a facet with such a
/// corner is wrong.
///
/// # Errors
///
/// A [`Failure`] where Day's program would not stop, or come upon a link that leads nowhere.
///
/// # Cost
///
/// Two cotangents for each question of [`preparata_hong_3d`](super::preparata_hong_3d()); in a format of software about a
/// microsecond each.
///
/// # Example
///
/// ```
/// use divide_and_conquer::preparata_hong_3d::cotangent::day_cotangent;
/// use geometry_core::Points;
/// use geometry_core::tolerance::formats::Extended;
/// let corner = [[0.0; 3], [1.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.1, 1.0]];
/// let facets = day_cotangent::<Extended>(Points::new(&corner)?, 1e16);
/// assert_eq!(facets.map(|facets| facets.len()), Ok(4));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn day_cotangent<F: Format>(
    points: Points<'_, 3>,
    eps2: f64,
) -> Result<Vec<[u32; 3]>, Failure> {
    if points.len() < 4 {
        return Err(Failure::TooFewPoints);
    }
    let rounded = rounded_up::<F>(points);
    let view = Points::new(&rounded).map_err(|_| Failure::Dangling)?;
    let mut ids: Vec<u32> = view.ids().collect();
    ids.sort_by(|&p, &q| geometry_core::kernel::space::lexicographic3(view[p], view[q]));
    let order = Order {
        points: ids.iter().map(|&id| view[id]).collect(),
        ids,
    };
    let questions = Cotangents::<F> {
        eps2,
        format: PhantomData,
    };
    let mut surface = Surface::<Resumed, _, _>::new(&order.points, &order.ids, &questions, Silent);
    let vertices = surface.conquer_by_fours(0..order.ids.len())?;
    Ok(surface.triangles(vertices)?)
}

/// How [`day_cotangent`] ends, judged by the exact hull of the points as rounded to `F`.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`](super::preparata_hong_3d()).
///
/// # Cost
///
/// That of both.
///
/// # Example
///
/// ```
/// use divide_and_conquer::preparata_hong_3d::cotangent::{Outcome, outcome};
/// use geometry_core::Points;
/// use geometry_core::tolerance::formats::Double;
/// let corner = [[0.0; 3], [1.0, 0.1, 0.0], [0.1, 1.0, 0.0], [0.0, 0.1, 1.0]];
/// assert_eq!(outcome::<Double>(Points::new(&corner)?, 1e10)?, Outcome::Right);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn outcome<F: Format>(points: Points<'_, 3>, eps2: f64) -> Result<Outcome, HullError> {
    let rounded: Vec<Point3> = points.as_slice().iter().map(round::<F>).collect();
    let hull = preparata_hong_3d(Points::new(&rounded)?, &Exact, &mut Silent)?;
    Ok(match day_cotangent::<F>(points, eps2) {
        Ok(facets) => {
            let loops = facets.iter().map(|facet| facet.to_vec()).collect();
            if Hull3::Solid(Solid::from_loops(loops)) == hull {
                Outcome::Right
            } else {
                Outcome::WrongHull
            }
        }
        Err(Failure::NotTerminating) => Outcome::NotTerminating,
        Err(Failure::Dangling | Failure::TooFewPoints) => Outcome::Dangling,
    })
}

fn round<F: Format>(point: &Point3) -> Point3 {
    point.map(|coordinate| F::of(coordinate).to_f64())
}

/// Day's `roundup_pcount`: the points in the format, and up to three inside to make their number a multiple of four.
fn rounded_up<F: Format>(points: Points<'_, 3>) -> Vec<Point3> {
    let mut rounded: Vec<Point3> = points.as_slice().iter().map(round::<F>).collect();
    let missing = rounded.len().next_multiple_of(4) - rounded.len();
    let part = 1.0 / rounded.len() as f64;
    let mean = |axis: usize| rounded.iter().map(|p| p[axis] * part).sum::<f64>();
    let centre = [0, 1, 2].map(mean);
    for i in 0..missing {
        let towards = rounded[i];
        let between = |axis: usize| centre[axis] + (towards[axis] - centre[axis]) / 8.0;
        rounded.push(round::<F>(&[0, 1, 2].map(between)));
    }
    rounded
}

/// Day's comparisons.
struct Cotangents<F> {
    eps2: f64,
    format: PhantomData<F>,
}

type Vector<F> = [F; 3];

/// What Day's `cot_val` may return.
enum Cotangent<F> {
    /// Taken for a half-turn: the largest angle.
    HalfTurn,
    /// Anything between.
    Number(F),
    /// Taken for an angle of 0.
    Nothing,
    /// 0 / 0. Compares like NaN: never less, never greater.
    Undefined,
}

impl<F: Format> Questions for Cotangents<F> {
    /// Day's `onleft`.
    fn shadow(&self, a: Point3, b: Point3, c: Point3) -> Sign {
        let [a, b, c] = [a, b, c].map(|p| p.map(F::of));
        let left = b[0].minus(a[0]).times(c[1].minus(a[1]));
        let right = b[1].minus(a[1]).times(c[0].minus(a[0]));
        Sign::of(left.minus(right).to_f64())
    }

    fn is_beyond(&self, bridge: &Bridge, x: Point3, y: Point3) -> bool {
        match (self.cotangent(bridge, y), self.cotangent(bridge, x)) {
            (Cotangent::Undefined, _) | (_, Cotangent::Undefined) => false,
            (Cotangent::HalfTurn, Cotangent::HalfTurn) => false,
            (Cotangent::HalfTurn, _) | (Cotangent::Number(_), Cotangent::Nothing) => true,
            (Cotangent::Number(y), Cotangent::Number(x)) => is_less(y, x),
            (Cotangent::Number(_), Cotangent::HalfTurn) | (Cotangent::Nothing, _) => false,
        }
    }
}

impl<F: Format> Cotangents<F> {
    /// Day's `cot_val`. His lower hull, to which his a belongs, is the second half here.
    fn cotangent(&self, bridge: &Bridge, v: Point3) -> Cotangent<F> {
        let [a, b, c, v] = [bridge.b, bridge.a, bridge.behind, v].map(|p| p.map(F::of));
        let along = difference(b, a);
        let Some(normal) = unit_normal(difference(v, a), along) else {
            return Cotangent::Undefined;
        };
        match unit_normal(normal, along) {
            Some(away) => self.of_vectors(difference(c, b), away, normal),
            None => Cotangent::Undefined,
        }
    }

    /// Day's `cotang`.
    fn of_vectors(&self, t: Vector<F>, away: Vector<F>, normal: Vector<F>) -> Cotangent<F> {
        let numerator = product(t, away);
        let quotient = F::of(0.0).minus(numerator).over(product(t, normal));
        match quotient {
            Some(cotangent) if cotangent.to_f64().abs() <= self.eps2 => {
                Cotangent::Number(cotangent)
            }
            Some(cotangent) if cotangent.to_f64().is_nan() => Cotangent::Undefined,
            None if numerator.to_f64() == 0.0 => Cotangent::Undefined,
            _ if numerator.to_f64() < 0.0 => Cotangent::Nothing,
            _ => Cotangent::HalfTurn,
        }
    }
}

fn is_less<F: Format>(x: F, y: F) -> bool {
    x.minus(y).to_f64() < 0.0
}

fn difference<F: Format>(to: Vector<F>, from: Vector<F>) -> Vector<F> {
    [0, 1, 2].map(|i| to[i].minus(from[i]))
}

fn product<F: Format>(p: Vector<F>, q: Vector<F>) -> F {
    let [x, y, z] = [0, 1, 2].map(|i| p[i].times(q[i]));
    x.plus(y).plus(z)
}

fn cross<F: Format>(p: Vector<F>, q: Vector<F>) -> Vector<F> {
    let minor = |i: usize, j: usize| p[i].times(q[j]).minus(p[j].times(q[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Day's `unit_norm`; `None` of parallel vectors.
fn unit_normal<F: Format>(p: Vector<F>, q: Vector<F>) -> Option<Vector<F>> {
    let normal = cross(p, q);
    let length = product(normal, normal).root()?;
    let [x, y, z] = normal.map(|coordinate| coordinate.over(length));
    Some([x?, y?, z?])
}

impl<F: Format> Surface<'_, Resumed, Cotangents<F>, Silent> {
    /// Day's `chull`: halves of a multiple of four points, down to four.
    fn conquer_by_fours(&mut self, range: Range<usize>) -> Result<u32, Fault> {
        if range.len() <= 4 {
            self.make_tetrahedron(range);
            return Ok(4);
        }
        let half = range.len() / 2;
        let middle = range.start + half - half % 4;
        let first = self.conquer_by_fours(range.start..middle)?;
        let second = self.conquer_by_fours(middle..range.end)?;
        self.merge(range, middle, first + second)
    }

    /// Day's `tetrahull`.
    fn make_tetrahedron(&mut self, range: Range<usize>) {
        let [a, mut b, mut c, d] = [0, 1, 2, 3].map(|i| (range.start + i) as u32);
        let [p, q, r, s] = [a, b, c, d].map(|place| self.point(place).map(F::of));
        let volume = product(cross(difference(q, p), difference(r, p)), difference(s, p));
        if volume.to_f64() < 0.0 {
            (b, c) = (c, b);
        }
        let pairs = [(a, b), (b, c), (c, a), (a, d), (b, d), (c, d)];
        let edges = pairs.map(|(from, to)| self.edges.make(from, to));
        let dart = |from: u32, to: u32| {
            let i = pairs.iter().position(|&pair| pair == (from, to));
            let j = pairs.iter().position(|&pair| pair == (to, from));
            i.map_or_else(|| edges[j.unwrap_or(0)].reversed(), |i| edges[i])
        };
        // Seen from d, a b c runs anticlockwise.
        for [u, v, w] in [[a, c, b], [a, b, d], [b, c, d], [c, a, d]] {
            for [u, v, w] in [[u, v, w], [v, w, u], [w, u, v]] {
                self.edges.link(Half::First, dart(v, u), dart(v, w));
            }
        }
        for (place, next) in [(a, b), (b, c), (c, d), (d, a)] {
            self.places[place as usize].spoke = dart(place, next).0;
        }
        self.scan_ring(range);
    }

    /// The facets of the one hull that is left.
    fn triangles(&self, vertices: u32) -> Result<Vec<[u32; 3]>, Fault> {
        let first = &self.places[0];
        if self.edges.live() + 6 != 3 * vertices as usize || !first.has_edges() {
            return Err(Fault::Tangled);
        }
        let facets = by_spiral(&self.edges, Dart(first.spoke), self.places.len())?;
        let corners = facets.into_iter().map(|dart| {
            let facet = self.edges.triangle(dart).ok_or(Fault::Tangled)?;
            Ok(facet.map(|dart| self.id(self.edges.origin(dart))))
        });
        corners.collect()
    }
}
