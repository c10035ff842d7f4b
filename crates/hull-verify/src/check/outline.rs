//! The outline of a claimed hull: whether its shape is sound, and where a point lies against it.

use super::finding::Finding;
use crate::arithmetic::{Frame, Turn, order};
use geometry_core::{Boundary, Hull2, Point2};
use std::cmp::Ordering;

/// Where a point lies against an outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Equal to this vertex.
    Vertex(u32),
    /// On this edge, strictly between its ends.
    Edge(u32, u32),
    /// Strictly inside.
    Inside,
    /// On the outer side of this edge.
    Outside(u32, u32),
    /// Off the line of a segment, other than a single point, or against the empty hull.
    Apart,
}

/// A vertex with its coordinates.
#[derive(Clone, Copy, Debug)]
struct Corner {
    id: u32,
    at: Point2,
}

/// An outline that passed steps 1 to 4 of the argument ([`super`]).
#[derive(Debug)]
pub(super) struct Outline {
    frame: Frame,
    chains: Chains,
}

#[derive(Debug)]
enum Chains {
    Empty,
    Point(Corner),
    /// In lexicographic order.
    Segment(Vec<Corner>),
    /// Both from the lexicographic minimum to the maximum, each of which is in both.
    ///
    /// ```text
    ///           upper
    ///        *----*-----*
    ///      /              \
    ///    *                  *    the edges of the upper chain run from right to left
    ///      \             /
    ///        *----*----*
    ///           lower
    /// ```
    Polygon {
        lower: Vec<Corner>,
        upper: Vec<Corner>,
    },
}

impl Outline {
    /// The outline of `hull`, or the findings of the first of steps 1 to 4 that fails. O(h log h).
    pub(super) fn new(
        points: &[Point2],
        frame: Frame,
        boundary: Boundary,
        hull: &Hull2,
    ) -> Result<Self, Vec<Finding>> {
        let corners = corners(points, hull)?;
        let shape = Shape {
            frame,
            boundary,
            corners,
        };
        let chains = match hull {
            Hull2::Empty => Chains::Empty,
            Hull2::Point(_) => Chains::Point(shape.corners[0]),
            Hull2::Segment(_) => shape.segment()?,
            Hull2::Polygon(_) => shape.polygon()?,
        };
        Ok(Self { frame, chains })
    }

    /// Where `p`, a point of the set, lies. O(log h).
    pub(super) fn locate(&self, p: Point2) -> Place {
        match &self.chains {
            Chains::Empty => Place::Apart,
            Chains::Point(only) if order(only.at, p).is_eq() => Place::Vertex(only.id),
            Chains::Point(_) => Place::Apart,
            Chains::Segment(row) => self.locate_on_line(row, p),
            Chains::Polygon { lower, upper } => self.locate_in_polygon(lower, upper, p),
        }
    }

    fn locate_on_line(&self, row: &[Corner], p: Point2) -> Place {
        let (first, last) = (row[0], row[row.len() - 1]);
        if self.frame.turn(first.at, last.at, p) != Turn::Straight {
            return Place::Apart;
        }
        match slot(row, p) {
            Slot::At(vertex) => Place::Vertex(vertex),
            Slot::Between(from, to) => Place::Edge(from.id, to.id),
            Slot::Before | Slot::After => Place::Outside(first.id, last.id),
        }
    }

    fn locate_in_polygon(&self, lower: &[Corner], upper: &[Corner], p: Point2) -> Place {
        let below = match slot(lower, p) {
            Slot::At(vertex) => return Place::Vertex(vertex),
            Slot::Before => return self.beyond(upper[1], lower[0], lower[1], p),
            Slot::After => {
                let [.., before, last] = lower else {
                    return Place::Apart;
                };
                return self.beyond(*before, *last, upper[upper.len() - 2], p);
            }
            Slot::Between(from, to) => self.against_edge(from, to, p),
        };
        let above = || match slot(upper, p) {
            Slot::At(vertex) => Place::Vertex(vertex),
            Slot::Between(to, from) => self.against_edge(from, to, p),
            // Both chains have the same ends, and p is between them.
            Slot::Before | Slot::After => Place::Inside,
        };
        if below == Place::Inside {
            above()
        } else {
            below
        }
    }

    /// The place of p as far as the edge from→to tells, for p between its ends lexicographically.
    fn against_edge(&self, from: Corner, to: Corner, p: Point2) -> Place {
        match self.frame.turn(from.at, to.at, p) {
            Turn::Left => Place::Inside,
            Turn::Straight => Place::Edge(from.id, to.id),
            Turn::Right => Place::Outside(from.id, to.id),
        }
    }

    /// The place of p that is lexicographically beyond the end `at` of the polygon.
    ///
    /// All that is on the inner side of both edges at `at` is on the other side of `at` in the lexicographic
    /// order, so p is outside at least one of them.
    fn beyond(&self, before: Corner, at: Corner, after: Corner, p: Point2) -> Place {
        if self.frame.turn(before.at, at.at, p) == Turn::Right {
            Place::Outside(before.id, at.id)
        } else {
            Place::Outside(at.id, after.id)
        }
    }
}

/// Where a point falls in a row of corners that ascends lexicographically.
enum Slot {
    Before,
    At(u32),
    Between(Corner, Corner),
    After,
}

fn slot(row: &[Corner], p: Point2) -> Slot {
    let next = row.partition_point(|corner| order(corner.at, p).is_lt());
    match row.get(next) {
        Some(corner) if order(corner.at, p).is_eq() => Slot::At(corner.id),
        Some(_) if next == 0 => Slot::Before,
        Some(&corner) => Slot::Between(row[next - 1], corner),
        None => Slot::After,
    }
}

/// Step 1: the vertices with their coordinates, as many as the variant needs, all distinct.
fn corners(points: &[Point2], hull: &Hull2) -> Result<Vec<Corner>, Vec<Finding>> {
    let mut corners = Vec::with_capacity(hull.len());
    let mut findings = Vec::new();
    for &id in hull.vertices() {
        match points.get(id as usize) {
            Some(&at) => corners.push(Corner { id, at }),
            None => findings.push(Finding::NoSuchPoint {
                id,
                count: points.len(),
            }),
        }
    }
    if !findings.is_empty() {
        return Err(findings);
    }
    let enough = match hull {
        Hull2::Empty | Hull2::Point(_) => true,
        Hull2::Segment(ids) => ids.len() >= 2,
        Hull2::Polygon(ids) => ids.len() >= 3,
    };
    if !enough {
        findings.push(Finding::WrongCount {
            claimed: hull.dimension(),
            count: hull.len(),
        });
        return Err(findings);
    }
    let mut sorted = corners.clone();
    sorted.sort_unstable_by(|a, b| order(a.at, b.at).then(a.id.cmp(&b.id)));
    for pair in sorted.windows(2) {
        let (first, second) = (pair[0], pair[1]);
        if first.id == second.id {
            findings.push(Finding::Repeated { id: first.id });
        } else if order(first.at, second.at).is_eq() {
            findings.push(Finding::EqualVertices {
                first: first.id,
                second: second.id,
            });
        }
    }
    if findings.is_empty() {
        Ok(corners)
    } else {
        Err(findings)
    }
}

/// Steps 2 to 4, on distinct corners.
struct Shape {
    frame: Frame,
    boundary: Boundary,
    corners: Vec<Corner>,
}

impl Shape {
    fn segment(self) -> Result<Chains, Vec<Finding>> {
        let row = &self.corners;
        let (first, last) = (row[0], row[row.len() - 1]);
        let mut findings = Vec::new();
        if order(first.at, last.at).is_gt() {
            findings.push(Finding::WrongStart {
                start: first.id,
                smallest: last.id,
            });
            return Err(findings);
        }
        for corner in row {
            if self.frame.turn(first.at, last.at, corner.at) != Turn::Straight {
                findings.push(Finding::WrongDimension {
                    claimed: Some(1),
                    witness: corner.id,
                });
            }
        }
        for pair in row.windows(2) {
            if order(pair[0].at, pair[1].at).is_gt() {
                findings.push(Finding::WrongOrder {
                    before: pair[0].id,
                    after: pair[1].id,
                });
            }
        }
        if self.boundary == Boundary::Extreme {
            for inner in &row[1..row.len() - 1] {
                findings.push(Finding::NoCorner {
                    before: first.id,
                    at: inner.id,
                    after: last.id,
                });
            }
        }
        if findings.is_empty() {
            Ok(Chains::Segment(self.corners))
        } else {
            Err(findings)
        }
    }

    fn polygon(self) -> Result<Chains, Vec<Finding>> {
        self.turns_left()?;
        self.goes_round_once()?;
        // From here on the corners ascend to one maximum and descend again.
        let top = self.position_of(Ordering::Greater);
        let mut upper = vec![self.corners[0]];
        upper.extend(self.corners[top..].iter().rev());
        let mut lower = self.corners;
        lower.truncate(top + 1);
        Ok(Chains::Polygon { lower, upper })
    }

    /// Step 2.
    fn turns_left(&self) -> Result<(), Vec<Finding>> {
        let mut findings = Vec::new();
        let (mut left, mut right) = (0, 0);
        for [before, at, after] in self.triples() {
            let ids = (before.id, at.id, after.id);
            match self.frame.turn(before.at, at.at, after.at) {
                Turn::Left => left += 1,
                Turn::Right => {
                    right += 1;
                    let (before, at, after) = ids;
                    findings.push(Finding::RightTurn { before, at, after });
                }
                Turn::Straight if order(before.at, at.at) != order(at.at, after.at) => {
                    let (before, at, after) = ids;
                    findings.push(Finding::TurnsBack { before, at, after });
                }
                Turn::Straight if self.boundary == Boundary::Extreme => {
                    let (before, at, after) = ids;
                    findings.push(Finding::NoCorner { before, at, after });
                }
                Turn::Straight => {}
            }
        }
        if left == 0 && right > 0 && findings.len() == right {
            findings = vec![Finding::Clockwise];
        }
        if findings.is_empty() {
            Ok(())
        } else {
            Err(findings)
        }
    }

    /// Steps 3 and 4.
    fn goes_round_once(&self) -> Result<(), Vec<Finding>> {
        let rises = |a: Corner, b: Corner| order(a.at, b.at).is_lt();
        let revolutions = self
            .triples()
            .filter(|&[before, at, after]| rises(before, at) && rises(after, at))
            .count();
        if revolutions != 1 {
            return Err(vec![Finding::Winding { revolutions }]);
        }
        let smallest = self.corners[self.position_of(Ordering::Less)];
        let start = self.corners[0];
        if start.id != smallest.id {
            return Err(vec![Finding::WrongStart {
                start: start.id,
                smallest: smallest.id,
            }]);
        }
        Ok(())
    }

    /// Every corner with the one before it and the one after it.
    fn triples(&self) -> impl Iterator<Item = [Corner; 3]> + '_ {
        let h = self.corners.len();
        (0..h).map(move |i| [(i + h - 1) % h, i, (i + 1) % h].map(|k| self.corners[k]))
    }

    /// The position of the corner that compares with every other as `end`: `Less` is the minimum.
    fn position_of(&self, end: Ordering) -> usize {
        (1..self.corners.len()).fold(0, |best, i| {
            if order(self.corners[i].at, self.corners[best].at) == end {
                i
            } else {
                best
            }
        })
    }
}
