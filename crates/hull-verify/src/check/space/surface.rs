//! The facets of a claimed solid as a surface: steps 1 and 2 of the argument ([`super`]).

use super::finding3::{Finding3, Order, verdict};
use crate::arithmetic::scale::order3;
use geometry_core::Point3;

/// A closed, connected surface of Euler characteristic two, whose corners are distinct points.
///
/// A *side* is an edge of one facet, from one of its corners to the next; they are numbered facet by facet.
#[derive(Debug)]
pub(super) struct Surface {
    /// Facet f has the sides `starts[f]..starts[f + 1]`.
    starts: Vec<u32>,
    /// The corner where each side begins.
    pub(super) origins: Vec<u32>,
    /// The facet of each side.
    pub(super) facets: Vec<u32>,
    /// The same edge in the other direction.
    pub(super) twins: Vec<u32>,
}

impl Surface {
    /// The surface with these vertices and facets, or what is wrong with its ids or its topology.
    ///
    /// O(m log m) for m sides.
    pub(super) fn new(
        points: &[Point3],
        vertices: &[u32],
        facets: &[&[u32]],
    ) -> Result<Self, Vec<Finding3>> {
        verdict(bad_ids(points, vertices, facets))?;
        verdict(out_of_order(vertices, facets))?;
        verdict(equal_vertices(points, vertices))?;
        let mut surface = Self {
            starts: vec![0],
            origins: facets.concat(),
            facets: Vec::new(),
            twins: Vec::new(),
        };
        for (number, corners) in (0..).zip(facets) {
            let sides = surface.facets.len() + corners.len();
            surface.facets.resize(sides, number);
            surface.starts.push(sides as u32);
        }
        surface.find_twins()?;
        surface.is_a_sphere(vertices)?;
        Ok(surface)
    }

    pub(super) fn facet_count(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn side_count(&self) -> usize {
        self.origins.len()
    }

    /// The corners of a facet.
    pub(super) fn corners(&self, facet: u32) -> &[u32] {
        &self.origins[self.first_side(facet) as usize..self.first_side(facet + 1) as usize]
    }

    pub(super) fn first_side(&self, facet: u32) -> u32 {
        self.starts[facet as usize]
    }

    pub(super) fn next(&self, side: u32) -> u32 {
        let facet = self.facets[side as usize];
        if side + 1 == self.first_side(facet + 1) {
            self.first_side(facet)
        } else {
            side + 1
        }
    }

    pub(super) fn origin(&self, side: u32) -> u32 {
        self.origins[side as usize]
    }

    pub(super) fn target(&self, side: u32) -> u32 {
        self.origin(self.next(side))
    }

    pub(super) fn twin(&self, side: u32) -> u32 {
        self.twins[side as usize]
    }

    /// The facet beyond a side.
    pub(super) fn facet_beyond(&self, side: u32) -> u32 {
        self.facets[self.twin(side) as usize]
    }

    fn find_twins(&mut self) -> Result<(), Vec<Finding3>> {
        // Each edge sorts next to its reverse, which has the same two ends.
        let mut edges: Vec<(u32, u32, bool, u32)> = (0..self.side_count() as u32)
            .map(|side| {
                let (from, to) = (self.origin(side), self.target(side));
                (from.min(to), from.max(to), from > to, side)
            })
            .collect();
        edges.sort_unstable();
        self.twins = vec![0; edges.len()];
        let mut findings = Vec::new();
        let same_ends =
            |a: &(u32, u32, bool, u32), b: &(u32, u32, bool, u32)| (a.0, a.1) == (b.0, b.1);
        for group in edges.chunk_by(same_ends) {
            match *group {
                [(.., false, up), (.., true, down)] => {
                    self.twins[up as usize] = down;
                    self.twins[down as usize] = up;
                }
                [(.., side)] => findings.push(Finding3::OpenEdge {
                    from: self.origin(side),
                    to: self.target(side),
                    facet: self.facets[side as usize],
                }),
                // Two in one direction, at least.
                _ => findings.extend(
                    group
                        .windows(2)
                        .filter(|pair| pair[0].2 == pair[1].2)
                        .map(|pair| self.shared(pair[0].3, pair[1].3)),
                ),
            }
        }
        verdict(findings)
    }

    fn shared(&self, side: u32, other: u32) -> Finding3 {
        Finding3::SharedEdge {
            from: self.origin(side),
            to: self.target(side),
            facets: [side, other].map(|side| self.facets[side as usize]),
        }
    }

    /// One cycle of facets at every vertex, one piece, Euler's formula.
    fn is_a_sphere(&self, vertices: &[u32]) -> Result<(), Vec<Finding3>> {
        verdict(self.pinched_vertices(vertices))?;
        if let Some(facet) = self.unreachable_facet() {
            return Err(vec![Finding3::Disconnected { facet }]);
        }
        let (edges, facets) = (self.side_count() / 2, self.facet_count());
        if vertices.len() + facets != edges + 2 {
            return Err(vec![Finding3::Euler {
                vertices: vertices.len(),
                edges,
                facets,
            }]);
        }
        Ok(())
    }

    fn pinched_vertices(&self, vertices: &[u32]) -> Vec<Finding3> {
        let mut cycles = vec![0_u32; vertices.len()];
        let mut seen = vec![false; self.side_count()];
        for start in 0..self.side_count() as u32 {
            if seen[start as usize] {
                continue;
            }
            if let Ok(place) = vertices.binary_search(&self.origin(start)) {
                cycles[place] += 1;
            }
            // Twin, then next, is a permutation of the sides that keeps their origin.
            let mut side = start;
            while !seen[side as usize] {
                seen[side as usize] = true;
                side = self.next(self.twin(side));
            }
        }
        vertices
            .iter()
            .zip(cycles)
            .filter(|&(_, cycles)| cycles != 1)
            .map(|(&vertex, cycles)| Finding3::PinchedVertex { vertex, cycles })
            .collect()
    }

    fn unreachable_facet(&self) -> Option<u32> {
        let mut reached = vec![false; self.facet_count()];
        reached[0] = true;
        let mut to_visit = vec![0];
        while let Some(facet) = to_visit.pop() {
            for side in self.first_side(facet)..self.first_side(facet + 1) {
                let beyond = self.facet_beyond(side);
                if !reached[beyond as usize] {
                    reached[beyond as usize] = true;
                    to_visit.push(beyond);
                }
            }
        }
        reached.iter().position(|&r| !r).map(|facet| facet as u32)
    }
}

fn bad_ids(points: &[Point3], vertices: &[u32], facets: &[&[u32]]) -> Vec<Finding3> {
    let count = points.len();
    let outside = vertices.iter().filter(|&&id| id as usize >= count);
    let mut findings: Vec<Finding3> = outside
        .map(|&id| Finding3::NoSuchPoint { id, count })
        .collect();
    for (facet, corners) in (0..).zip(facets) {
        if corners.len() < 3 {
            let count = corners.len();
            findings.push(Finding3::FewCorners { facet, count });
        }
    }
    if facets.is_empty() {
        let (vertices, edges, facets) = (vertices.len(), 0, 0);
        findings.push(Finding3::Euler {
            vertices,
            edges,
            facets,
        });
    }
    findings
}

/// What of the canonical order is not kept.
fn out_of_order(vertices: &[u32], facets: &[&[u32]]) -> Vec<Finding3> {
    let mut findings = Vec::new();
    let mut corners = facets.concat();
    corners.sort_unstable();
    corners.dedup();
    if corners != vertices {
        findings.push(Order::Vertices);
    }
    for (facet, corners) in (0..).zip(facets) {
        if corners.iter().min() != corners.first() {
            findings.push(Order::Corners(facet));
        }
    }
    for (facet, pair) in (1..).zip(facets.windows(2)) {
        if pair[0] > pair[1] {
            findings.push(Order::Facet(facet));
        }
    }
    let not_canonical = |what| Finding3::NotCanonical { what };
    findings.into_iter().map(not_canonical).collect()
}

fn equal_vertices(points: &[Point3], vertices: &[u32]) -> Vec<Finding3> {
    let at = |id: u32| points[id as usize];
    let mut sorted = vertices.to_vec();
    sorted.sort_unstable_by(|&a, &b| order3(at(a), at(b)).then(a.cmp(&b)));
    let pairs = sorted.windows(2);
    let equal = pairs.filter(|pair| order3(at(pair[0]), at(pair[1])).is_eq());
    equal
        .map(|pair| Finding3::EqualVertices {
            first: pair[0],
            second: pair[1],
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values of [`geometry_core::hull3::Solid`] are in order by construction, so what is not is tried here.
    #[test]
    fn what_is_out_of_order_is_found() {
        let facets: [&[u32]; 4] = [&[0, 1, 3], &[0, 2, 1], &[0, 3, 2], &[1, 2, 3]];
        assert_eq!(out_of_order(&[0, 1, 2, 3], &facets), []);
        let not_canonical = |what| vec![Finding3::NotCanonical { what }];
        for vertices in [&[0, 1, 2][..], &[0, 2, 1, 3], &[0, 1, 2, 3, 4]] {
            assert_eq!(
                out_of_order(vertices, &facets),
                not_canonical(Order::Vertices)
            );
        }
        let swapped = [facets[0], facets[2], facets[1], facets[3]];
        assert_eq!(
            out_of_order(&[0, 1, 2, 3], &swapped),
            not_canonical(Order::Facet(2))
        );
        let turned = [facets[0], facets[1], &[2, 0, 3], facets[3]];
        let findings = out_of_order(&[0, 1, 2, 3], &turned);
        assert_eq!(
            findings[0],
            Finding3::NotCanonical {
                what: Order::Corners(2)
            }
        );
    }
}
