//! The certificate of convex layers.

use super::contradiction;
use super::finding::{Finding, reject_unusable};
use super::outline::{Outline, Place};
use crate::arithmetic::{Frame, Width};
use geometry_core::{Boundary, Hull2, Layers, Point2};

/// What was established about convex layers: `n = vertices + copies`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayersCertificate {
    /// The number of points, each found to have been removed by the right ring.
    pub n: usize,
    /// The number of rings, each found to be the hull of what remained.
    pub rings: usize,
    /// The number of vertices of all rings.
    pub vertices: usize,
    /// Points removed as copies of a vertex.
    pub copies: usize,
    /// The convention the rings were checked for.
    pub boundary: Boundary,
    /// How wide the integers were.
    pub width: Width,
}

/// Certifies that `layers` are the convex layers of `points`, as the canonical value that [`Layers`] promises.
///
/// # Errors
///
/// Every [`Finding`], those about one ring inside [`Finding::InRing`]. Any value of `layers` whatever is
/// accepted, and the list is never empty.
///
/// # Cost
///
/// O(n log h) time for all rings together, h the most vertices of one; O(n) space.
///
/// ```
/// use geometry_core::{Boundary, Hull2, Layers};
/// use hull_verify::check;
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
/// let layers = Layers::new(vec![Hull2::Polygon(vec![0, 1, 2]), Hull2::Point(3)], vec![1, 1, 1, 2]);
/// let certificate = check::layers(&points, Boundary::Extreme, &layers).unwrap();
/// assert_eq!(certificate.rings, 2);
/// ```
pub fn layers(
    points: &[Point2],
    boundary: Boundary,
    layers: &Layers,
) -> Result<LayersCertificate, Vec<Finding>> {
    reject_unusable(points)?;
    let members = members(points.len(), layers)?;
    let set = Set {
        points,
        boundary,
        frame: Frame::of(points),
        layers,
        members,
    };
    let findings: Vec<Finding> = (0..layers.len())
        .flat_map(|i| set.findings_in_ring(i))
        .collect();
    if !findings.is_empty() {
        return Err(findings);
    }
    let vertices = layers.rings().iter().map(Hull2::len).sum();
    Ok(LayersCertificate {
        n: points.len(),
        rings: layers.len(),
        vertices,
        copies: points.len() - vertices,
        boundary,
        width: set.frame.width(),
    })
}

/// The points of each rank, the points of rank i+1 at i; or what is wrong with the ranks.
fn members(count: usize, layers: &Layers) -> Result<Vec<Vec<u32>>, Vec<Finding>> {
    let (ranks, rings) = (layers.c_ranks(), layers.len());
    if ranks.len() != count {
        return Err(vec![Finding::RankCount {
            ranks: ranks.len(),
            count,
        }]);
    }
    let mut members = vec![Vec::new(); rings];
    let mut findings = Vec::new();
    for (point, &rank) in (0..).zip(ranks) {
        match (rank as usize)
            .checked_sub(1)
            .and_then(|i| members.get_mut(i))
        {
            Some(ring) => ring.push(point),
            None => findings.push(Finding::NoSuchRing { point, rank, rings }),
        }
    }
    if findings.is_empty() {
        Ok(members)
    } else {
        Err(findings)
    }
}

struct Set<'a> {
    points: &'a [Point2],
    boundary: Boundary,
    frame: Frame,
    layers: &'a Layers,
    members: Vec<Vec<u32>>,
}

impl Set<'_> {
    /// All that is wrong with the ring at `i`, with the points of its rank, and with those of the next rank
    /// against it.
    fn findings_in_ring(&self, i: usize) -> Vec<Finding> {
        let ring = i as u32 + 1;
        let hull = &self.layers.rings()[i];
        if hull.is_empty() {
            return vec![Finding::EmptyRing { ring }];
        }
        let in_ring = |finding| Finding::InRing {
            ring,
            finding: Box::new(finding),
        };
        let outline = match Outline::new(self.points, self.frame, self.boundary, hull) {
            Ok(outline) => outline,
            Err(findings) => return findings.into_iter().map(in_ring).collect(),
        };
        let mut findings = Vec::new();
        for &vertex in hull.vertices() {
            let rank = self.layers.c_ranks()[vertex as usize];
            if rank != ring {
                findings.push(Finding::WrongRank { ring, vertex, rank });
            }
        }
        for &point in &self.members[i] {
            let place = outline.locate(self.points[point as usize]);
            if let Place::Vertex(_) = place {
                findings.extend(contradiction(self.boundary, hull, point, place).map(in_ring));
            } else {
                findings.push(Finding::NotOnRing { ring, point });
            }
        }
        for &point in self.members.get(i + 1).into_iter().flatten() {
            let place = outline.locate(self.points[point as usize]);
            if let Place::Vertex(vertex) = place {
                findings.push(Finding::CopyLeft {
                    ring,
                    vertex,
                    copy: point,
                });
            } else {
                findings.extend(contradiction(self.boundary, hull, point, place).map(in_ring));
            }
        }
        findings
    }
}
