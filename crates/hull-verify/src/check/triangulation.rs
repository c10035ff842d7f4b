//! The certificate of a Delaunay triangulation.
//!
//! # The argument
//!
//! 1. Every corner is a point of the set, the smallest of its copies, and every distinct point is a corner.
//! 2. Every triangle is anticlockwise, and no two have an edge in the same direction.
//! 3. The edges of one triangle only form an outline that turns left or runs straight on everywhere and goes round
//!    once. So it bounds a convex polygon; it winds once round every point inside, and all triangles being
//!    anticlockwise, as many of them cover a point as the outline winds round it: they cover the polygon once. Since
//!    every point is a corner, the polygon is the convex hull; and a point inside a triangle or an edge would have its
//!    own triangles overlap those there.
//! 4. For every edge of two triangles, the corner beyond is not inside the circle round the other triangle. Lifted to
//!    the paraboloid z = x² + y², this says that the surface over the triangles is convex at the edge; a function on
//!    a convex polygon that is convex across every edge is convex, so the lifted triangles are the lower hull of the
//!    lifted points: no circle round a triangle has any point inside (Delaunay 1934: what holds at every edge holds
//!    everywhere).
//!
//! Where more than three points are on an empty circle every triangulation of them is a Delaunay triangulation, and
//! the certificate says how many edges are such a choice.

mod finding;

pub use finding::DelaunayFinding;

use super::cycle::{Fault, convex_outline};
use crate::arithmetic::scale::Scale;
use crate::arithmetic::{Frame, Turn, order};
use geometry_core::{Point2, Triangulation};

/// What was established about a triangulation. The points are accounted for: `n = vertices + copies`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DelaunayCertificate {
    /// The number of points.
    pub n: usize,
    /// The number of distinct points: all are corners, unless they are collinear.
    pub vertices: usize,
    /// The number of triangles, each found to be anticlockwise.
    pub triangles: usize,
    /// The number of edges of the hull.
    pub hull_edges: usize,
    /// Points that have a copy of smaller index.
    pub copies: usize,
    /// Edges between two triangles on one circle: where there are none, the triangulation is the only one.
    pub cocircular: usize,
}

/// Certifies that `triangulation` is a Delaunay triangulation of `points`.
///
/// Collinear points, and fewer than three, have no triangles, and the right triangulation is empty.
///
/// # Errors
///
/// Every [`DelaunayFinding`] of the first step that fails: a later step presumes the earlier. The list is never empty.
///
/// # Cost
///
/// O(n log n + t log t) time for t triangles, O(n + t) space.
///
/// ```
/// use geometry_core::Triangulation;
/// use hull_verify::check::{self, DelaunayFinding};
/// let kite = [[0.0, 0.0], [2.0, -1.0], [4.0, 0.0], [2.0, 1.0]];
/// let right = Triangulation::new(vec![[0, 1, 3], [1, 2, 3]]);
/// assert_eq!(check::delaunay(&kite, &right).unwrap().hull_edges, 4);
/// let wrong = Triangulation::new(vec![[0, 1, 2], [0, 2, 3]]);
/// let findings = check::delaunay(&kite, &wrong).unwrap_err();
/// assert_eq!(findings, [DelaunayFinding::InCircle { triangle: 1, point: 1 }]);
/// ```
pub fn delaunay(
    points: &[Point2],
    triangulation: &Triangulation,
) -> Result<DelaunayCertificate, Vec<DelaunayFinding>> {
    reject_unusable(points)?;
    let set = Set {
        points,
        frame: Frame::of(points),
        triangles: triangulation.triangles(),
    };
    let vertices = set.vertices()?;
    let (mut hull_edges, mut cocircular) = (0, 0);
    if set.triangles.is_empty() {
        verdict(set.not_collinear().into_iter().collect())?;
    } else {
        verdict(set.misshapen())?;
        let edges = set.edges()?;
        hull_edges = set.outline(&edges)?;
        cocircular = set.empty_circles(&edges)?;
    }
    Ok(DelaunayCertificate {
        n: points.len(),
        vertices,
        triangles: set.triangles.len(),
        hull_edges,
        copies: points.len() - vertices,
        cocircular,
    })
}

/// An edge of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Edge {
    /// Its ends, the smaller first.
    ends: [u32; 2],
    /// Whether it runs from the larger to the smaller.
    falls: bool,
    /// Which of the triangles has it.
    triangle: u32,
    /// Which corner of that triangle is opposite.
    apex: u32,
}

impl Edge {
    /// From where to where it runs in its triangle.
    fn directed(&self) -> [u32; 2] {
        let [low, high] = self.ends;
        if self.falls { [high, low] } else { [low, high] }
    }
}

struct Set<'a> {
    points: &'a [Point2],
    frame: Frame,
    triangles: &'a [[u32; 3]],
}

impl Set<'_> {
    fn at(&self, id: u32) -> Point2 {
        self.points[id as usize]
    }

    /// Step 1: the number of distinct points.
    fn vertices(&self) -> Result<usize, Vec<DelaunayFinding>> {
        let count = self.points.len();
        let corners = || self.triangles.as_flattened().iter().copied();
        let strangers = corners().filter(|&id| id as usize >= count);
        verdict(
            strangers
                .map(|id| DelaunayFinding::NoSuchPoint { id, count })
                .collect(),
        )?;
        let mut is_corner = vec![false; count];
        for id in corners() {
            is_corner[id as usize] = true;
        }
        let mut sorted: Vec<u32> = (0..count as u32).collect();
        sorted.sort_unstable_by(|&a, &b| order(self.at(a), self.at(b)).then(a.cmp(&b)));
        let mut findings = Vec::new();
        let mut vertices = 0;
        for copies in sorted.chunk_by(|&a, &b| order(self.at(a), self.at(b)).is_eq()) {
            vertices += 1;
            let smaller = copies[0];
            let listed = |&&id: &&u32| is_corner[id as usize];
            for &vertex in copies[1..].iter().filter(listed) {
                findings.push(DelaunayFinding::LargerCopy { vertex, smaller });
            }
            if !self.triangles.is_empty() && !copies.iter().any(|id| listed(&id)) {
                findings.push(DelaunayFinding::MissingVertex { point: smaller });
            }
        }
        verdict(findings).map(|()| vertices)
    }

    /// Three points that are not collinear, if there are.
    fn not_collinear(&self) -> Option<DelaunayFinding> {
        let ids = || 0..self.points.len() as u32;
        let first = ids().min_by(|&a, &b| order(self.at(a), self.at(b)))?;
        let last = ids().max_by(|&a, &b| order(self.at(a), self.at(b)))?;
        let off_line = |&id: &u32| {
            self.frame.turn(self.at(first), self.at(last), self.at(id)) != Turn::Straight
        };
        let witnesses = [first, last, ids().find(off_line)?];
        Some(DelaunayFinding::NoTriangles { witnesses })
    }

    /// Step 2, the triangles.
    fn misshapen(&self) -> Vec<DelaunayFinding> {
        let mut findings = Vec::new();
        for (triangle, corners) in (0..).zip(self.triangles) {
            let [a, b, c] = corners.map(|id| self.at(id));
            match self.frame.turn(a, b, c) {
                Turn::Left => {}
                Turn::Straight => findings.push(DelaunayFinding::FlatTriangle { triangle }),
                Turn::Right => findings.push(DelaunayFinding::Clockwise { triangle }),
            }
        }
        findings
    }

    /// Step 2, the edges: sorted, so that the two of an inner edge stand side by side.
    fn edges(&self) -> Result<Vec<Edge>, Vec<DelaunayFinding>> {
        let of_triangle = |(triangle, &[a, b, c]): (u32, &[u32; 3])| {
            [[a, b, c], [b, c, a], [c, a, b]].map(|[from, to, apex]| Edge {
                ends: [from.min(to), from.max(to)],
                falls: from > to,
                triangle,
                apex,
            })
        };
        let mut edges: Vec<Edge> = (0..).zip(self.triangles).flat_map(of_triangle).collect();
        edges.sort_unstable();
        let same = |pair: &&[Edge]| pair[0].directed() == pair[1].directed();
        let shared = edges.windows(2).filter(same).map(|pair| {
            let [from, to] = pair[0].directed();
            DelaunayFinding::SharedEdge {
                from,
                to,
                triangles: [pair[0].triangle, pair[1].triangle],
            }
        });
        verdict(shared.collect())?;
        Ok(edges)
    }

    /// Step 3: the number of edges on the outline.
    fn outline(&self, edges: &[Edge]) -> Result<usize, Vec<DelaunayFinding>> {
        let single = edges
            .chunk_by(|a, b| a.ends == b.ends)
            .filter(|group| group.len() == 1);
        let outline: Vec<[u32; 2]> = single.map(|group| group[0].directed()).collect();
        let count = outline.len();
        let turn = |a, b, c| self.frame.turn(self.at(a), self.at(b), self.at(c));
        let order = |a, b| order(self.at(a), self.at(b));
        match convex_outline(outline, turn, order) {
            Ok(()) => Ok(count),
            Err(Fault::Winding(revolutions)) => {
                Err(vec![DelaunayFinding::OutlineWinding { revolutions }])
            }
            Err(Fault::Breaks(vertices)) => Err(vertices
                .into_iter()
                .map(|vertex| DelaunayFinding::OutlineBreaks { vertex })
                .collect()),
        }
    }

    /// Step 4: the number of inner edges between two triangles on one circle.
    fn empty_circles(&self, edges: &[Edge]) -> Result<usize, Vec<DelaunayFinding>> {
        let scale = Scale::of(self.points);
        let mut findings = Vec::new();
        let mut cocircular = 0;
        for group in edges.chunk_by(|a, b| a.ends == b.ends) {
            let [here, beyond] = group else { continue };
            let [a, b, c] = self.triangles[here.triangle as usize].map(|id| self.at(id));
            let inside = scale.in_circle(a, b, c, self.at(beyond.apex));
            cocircular += usize::from(inside.is_eq());
            if inside.is_gt() {
                findings.push(DelaunayFinding::InCircle {
                    triangle: here.triangle,
                    point: beyond.apex,
                });
            }
        }
        verdict(findings).map(|()| cocircular)
    }
}

fn reject_unusable(points: &[Point2]) -> Result<(), Vec<DelaunayFinding>> {
    if u32::try_from(points.len()).is_err() {
        let count = points.len();
        return Err(vec![DelaunayFinding::TooManyPoints { count }]);
    }
    let not_finite = |(point, p): (usize, &Point2)| {
        (!p.iter().all(|x| x.is_finite())).then_some(DelaunayFinding::NotFinite { point })
    };
    verdict(points.iter().enumerate().filter_map(not_finite).collect())
}

fn verdict(findings: Vec<DelaunayFinding>) -> Result<(), Vec<DelaunayFinding>> {
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings)
    }
}
