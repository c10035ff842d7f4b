//! Gift wrapping in space: turn a plane about each open edge until it meets the points.
//!
//! **Papers.** D. R. Chand and S. S. Kapur, "An algorithm for convex polytopes", *Journal of the ACM* 17(1), 78–86,
//! 1970, whose method this is in three dimensions; R. A. Jarvis, *Information Processing Letters* 2(1), 18–21,
//! 1973, for the search by comparison in the plane.
//!
//! **Essence.**
//!
//! 1. Find a first edge: a vertical plane through the lexicographically smallest point that has all points on one
//!    side; any edge of what lies in it.
//! 2. While there is an edge u→v whose facet is not known, *pivot*: go once through the points and keep the best so
//!    far, w, replacing it by every point outside the plane u v w. Keep a list of the points found in that plane.
//! 3. The facet is the planar hull of u, v and the list. Its other sides, reversed, are new open edges.
//!
//! ```text
//!                w'      p lies outside the plane u v w:        seen along the edge,   v=u ___ w
//!               /        w becomes p                            u towards us              \
//!          v --+--. w                                                                      \ p
//!          |  /                                                                             '
//!          u '           p in the plane u v w: onto the list
//! ```
//!
//! **Bound.** One pass a facet, and in general position exactly n - 3 orientations a pass: (2h - 4)(n - 3), O(n h).
//! Facets are counted as they truly are, however many points lie in one. Space: the edges, and one list.
//!
//! **Coplanar points.** Every other spatial method here works on a perturbed copy of the points and merges coplanar
//! triangles at the end. This one is exact without: a pass finds *all* points of the facet's plane, and their hull is
//! a planar matter. It is also the cheaper way: a perturbed plane with k points in it breaks into up to 2k triangles,
//! each of which would cost a pass through all points.
//!
//! **Invariants.**
//!
//! 1. u→v is a whole edge of the hull, from one extreme point to another. So the points lie in a wedge of less than
//!    180° about it, "outside" is a total order of the half-planes on that edge, and points collinear with u and v
//!    lie between them and are corners of nothing.
//! 2. The list holds all points met in the plane u v w since w was chosen, and no point met lies outside the plane.
//! 3. A side belongs to one facet only.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When h may be large: with h of the order of n it is quadratic. With few vertices among many
//! points it is short, and asks little that a filter cannot settle.

use geometry_core::dimension::AffineBasis;
use geometry_core::{Axis, Hull3, HullError, Kernel3, Observer, Point3, Points, Sign, Solid, Step};
use std::collections::HashSet;

/// Where this file departs from the papers, and why.
pub const DEPARTURES: &[&str] = &[
    "angles are not computed: of two candidates the better is told by one orientation",
    "a facet with any number of corners is found by one pass and one planar hull; Chand and Kapur recur on the \
     dimension for it",
    "the first edge is an edge of the face in a vertical supporting plane, whatever the dimension of that face",
];

/// The convex hull in space by pivoting a plane about every edge.
///
/// # Errors
///
/// [`HullError::Contradiction`] if two facets claim one side; cannot happen with an exact kernel.
///
/// # Cost
///
/// At most n - 3 orientations a facet, and n for the first edge. Time O(n f) for f facets; O(k log k) more for a facet
/// with k points in its plane. Space O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// // A pyramid: a square, its centre twice, and an apex.
/// let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0],
///               [1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0]];
/// let hull = gift_wrap::pivot_wrap(Points::new(&points)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 2, 3, 6]);
/// assert_eq!(hull.facets().collect::<Vec<_>>(), [&[0, 1, 6][..], &[0, 3, 2, 1], &[0, 6, 3], &[1, 2, 6], &[2, 3, 6]]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn pivot_wrap<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    if let Ok(flat) = AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        return Ok(flat);
    }
    let mut wrapping = Wrapping {
        points,
        kernel,
        observer,
        facets: Vec::new(),
        sides: HashSet::new(),
    };
    let mut open = vec![wrapping.first_edge()?];
    while let Some(edge) = open.pop() {
        if wrapping.sides.contains(&edge) {
            continue;
        }
        let facet = wrapping.pivot(edge)?;
        for [from, to] in sides_of(&facet) {
            wrapping.take_side([from, to])?;
            if !wrapping.sides.contains(&[to, from]) {
                open.push([to, from]);
            }
        }
        wrapping.add(facet)?;
    }
    Ok(Hull3::Solid(Solid::from_loops(wrapping.facets)))
}

/// The sides of a facet in order, from the one that starts at its first corner.
fn sides_of(facet: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = facet.iter().cycle().skip(1);
    facet.iter().zip(next).map(|(&from, &to)| [from, to])
}

struct Wrapping<'a, K, O> {
    points: Points<'a, 3>,
    kernel: &'a K,
    observer: &'a mut O,
    facets: Vec<Vec<u32>>,
    /// The sides of all facets. Only membership is asked.
    sides: HashSet<[u32; 2]>,
}

impl<K: Kernel3, O: Observer> Wrapping<'_, K, O> {
    /// Step 1. The search is Jarvis's in the shadows along z, from the smallest of them: `a` and what is above it.
    fn first_edge(&mut self) -> Result<[u32; 2], HullError> {
        let (points, kernel) = (self.points, self.kernel);
        let is_before = |p: u32, q: u32| kernel.lexicographic3(points[p], points[q]).is_lt();
        let smallest = points
            .ids()
            .reduce(|a, p| if is_before(p, a) { p } else { a });
        let a = smallest.ok_or(NO_EDGE)?;
        let flat = |id: u32| flattened(points[id]);
        let mut above_a = Vec::new();
        let mut in_plane: Vec<u32> = Vec::new();
        for p in points.ids() {
            if kernel.lexicographic3(flat(a), flat(p)).is_eq() {
                above_a.push(p);
                continue;
            }
            let side = match in_plane.first() {
                Some(&best) => kernel.shadow(Axis::Z, points[a], points[best], points[p]),
                None => Sign::Negative,
            };
            match side {
                Sign::Negative => in_plane = vec![p],
                Sign::Zero => in_plane.push(p),
                Sign::Positive => {}
            }
        }
        in_plane.append(&mut above_a);
        let face = self.hull_of(in_plane, |sub| {
            AffineBasis::of(sub, kernel).flat_hull(sub, kernel)
        })?;
        let &[u, v, ..] = face.as_slice() else {
            return Err(NO_EDGE);
        };
        self.observer.step(|| Step::Edge(u, v));
        Ok([u, v])
    }

    /// Steps 2 and 3: the facet on the side `edge`, anticlockwise seen from outside.
    fn pivot(&mut self, edge: [u32; 2]) -> Result<Vec<u32>, HullError> {
        self.observer.step(|| Step::Line(edge[0], edge[1]));
        let (points, kernel) = (self.points, self.kernel);
        let [u, v] = edge.map(|id| points[id]);
        let mut candidates = points.ids().filter(|id| !edge.contains(id));
        let first = candidates.find(|&id| !kernel.collinear3(u, v, points[id]));
        let mut best = first.ok_or(NO_EDGE)?;
        let mut in_plane = vec![best];
        loop {
            // While the plane stands, what it takes to ask about it stays in registers.
            let plane = [u, v, points[best]];
            let next = candidates.find_map(|p| {
                self.observer.step(|| Step::Visit(p));
                let side = kernel.orient3(plane[0], plane[1], plane[2], points[p]);
                (!side.is_negative()).then_some((p, side))
            });
            let Some((p, side)) = next else { break };
            if side.is_positive() {
                self.observer.step(|| Step::Apex(p));
                best = p;
                in_plane.clear();
            }
            in_plane.push(p);
        }
        if in_plane.len() == 1 {
            return Ok(vec![edge[0], edge[1], best]);
        }
        in_plane.extend(edge);
        self.polygon(edge, best, in_plane)
    }

    /// The hull of the coplanar points `ids`, in the direction in which `edge` is a side.
    fn polygon(&self, edge: [u32; 2], apex: u32, ids: Vec<u32>) -> Result<Vec<u32>, HullError> {
        let place_of = |sub: Points<'_, 3>, id: u32| {
            let is_it = |&place: &u32| {
                self.kernel
                    .lexicographic3(sub[place], self.points[id])
                    .is_eq()
            };
            sub.ids().find(is_it).unwrap_or(0)
        };
        let mut polygon = self.hull_of(ids, |sub| {
            let triangle = [edge[0], edge[1], apex].map(|id| place_of(sub, id));
            AffineBasis::Plane(triangle).flat_hull(sub, self.kernel)
        })?;
        if !sides_of(&polygon).any(|side| side == edge) {
            polygon.reverse();
        }
        if polygon.len() < 3 || !sides_of(&polygon).any(|side| side == edge) {
            return Err(HullError::Contradiction {
                what: "an edge of the hull is not a side of the facet found on it",
            });
        }
        Ok(polygon)
    }

    /// The vertices of the hull, by `find`, of some of the points.
    fn hull_of<E>(
        &self,
        mut ids: Vec<u32>,
        find: impl FnOnce(Points<'_, 3>) -> Result<Hull3, E>,
    ) -> Result<Vec<u32>, HullError> {
        // In ascending order the smallest index of copies here is the smallest there.
        ids.sort_unstable();
        let places: Vec<Point3> = ids.iter().map(|&id| self.points[id]).collect();
        let hull = find(Points::new(&places)?).map_err(|_| NOT_FLAT)?;
        Ok(hull
            .vertices()
            .iter()
            .map(|&place| ids[place as usize])
            .collect())
    }

    /// Invariant 3.
    fn take_side(&mut self, side: [u32; 2]) -> Result<(), HullError> {
        if self.sides.insert(side) {
            return Ok(());
        }
        Err(HullError::Contradiction {
            what: "two facets have the same side",
        })
    }

    fn add(&mut self, facet: Vec<u32>) -> Result<(), HullError> {
        for edge in facet.windows(2).skip(1) {
            self.observer
                .step(|| Step::Facet(facet[0], edge[0], edge[1]));
        }
        self.facets.push(facet);
        // Euler: a polyhedron on n corners has at most 2n - 4 facets. Only a rounded kernel goes on.
        if self.facets.len() > 2 * self.points.len() {
            return Err(HullError::Contradiction {
                what: "more facets than a polyhedron on these points can have",
            });
        }
        Ok(())
    }
}

const NO_EDGE: HullError = HullError::Contradiction {
    what: "points that span space have no edge to start from",
};

const NOT_FLAT: HullError = HullError::Contradiction {
    what: "points in a supporting plane span space",
};

fn flattened([x, y, _]: Point3) -> Point3 {
    [x, y, 0.0]
}
