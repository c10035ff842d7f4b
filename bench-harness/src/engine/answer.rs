//! A hull as it travels: parts of indices, and the values they stand for.

use super::protocol::{HullHeader, Kind, Problem};
use crate::claimed;
use geometry_core::{Hull2, Hull3, Layers, Points, Triangulation};
use std::io::{self, Write};

/// What an engine computed: lists of indices of the points, and how to read them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    kind: Kind,
    lengths: Vec<u32>,
    indices: Vec<u32>,
}

impl Answer {
    /// The answer with these parts.
    pub fn new<P: AsRef<[u32]>>(kind: Kind, parts: impl IntoIterator<Item = P>) -> Self {
        let mut answer = Self {
            kind,
            lengths: Vec::new(),
            indices: Vec::new(),
        };
        for part in parts {
            let part = part.as_ref();
            answer.lengths.push(part.len() as u32);
            answer.indices.extend_from_slice(part);
        }
        answer
    }

    /// How the parts are to be read.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// The parts: one cycle, or facets, triangles, layers.
    pub fn parts(&self) -> impl Iterator<Item = &[u32]> {
        let mut rest = &self.indices[..];
        self.lengths.iter().map(move |&length| {
            let (part, after) = rest.split_at(length as usize);
            rest = after;
            part
        })
    }

    /// The indices that occur, ascending, each once.
    pub fn vertices(&self) -> Vec<u32> {
        let mut vertices = self.indices.clone();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The header that goes before the arrays.
    pub fn header(&self) -> HullHeader {
        HullHeader {
            kind: self.kind,
            lengths: self.lengths.len(),
            indices: self.indices.len(),
        }
    }

    /// Writes the two arrays.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let numbers = self.lengths.iter().chain(&self.indices);
        let bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
        out.write_all(&bytes)
    }

    /// The answer about `n` points whose arrays are `bytes`.
    ///
    /// # Errors
    ///
    /// What is wrong with the arrays, in words: lengths that do not add up, an index of no point.
    pub fn read(header: HullHeader, bytes: &[u8], n: u32) -> Result<Self, String> {
        let (numbers, _) = bytes.as_chunks();
        let mut lengths: Vec<u32> = numbers.iter().map(|b| u32::from_le_bytes(*b)).collect();
        let indices = lengths.split_off(header.lengths.min(lengths.len()));
        let sum: u64 = lengths.iter().map(|&length| u64::from(length)).sum();
        if indices.len() != header.indices || sum != header.indices as u64 {
            return Err(format!(
                "parts of {sum} indices in all, of {}",
                header.indices
            ));
        }
        if let Some(index) = indices.iter().find(|&&index| index >= n) {
            return Err(format!("index {index} of {n} points"));
        }
        Ok(Self {
            kind: header.kind,
            lengths,
            indices,
        })
    }

    /// The most bytes that the arrays about `n` points can have; more is no hull.
    ///
    /// A spatial hull or a triangulation has fewer than 2n triangles; twice that leaves room for answers that are
    /// wrong in an interesting way.
    pub fn most_bytes(problem: Problem, n: u32) -> usize {
        const LEAST: usize = 64;
        let parts = match problem {
            Problem::Hull2 => 1,
            Problem::Layers => 2 * n as usize,
            Problem::Hull3 | Problem::Delaunay => 4 * n as usize,
        };
        let indices = match problem {
            Problem::Hull2 | Problem::Layers => 2 * n as usize,
            Problem::Hull3 | Problem::Delaunay => 12 * n as usize,
        };
        size_of::<u32>() * (LEAST + parts + indices)
    }

    /// The planar hull that this stands for, if it is a cycle.
    pub fn hull2(&self, points: Points<'_, 2>) -> Option<Hull2> {
        (self.kind == Kind::Cycle).then(|| claimed::planar(points, self.indices.clone()))
    }

    /// The spatial hull that this stands for, if it is a list of facets.
    pub fn hull3(&self, points: Points<'_, 3>) -> Option<Hull3> {
        (self.kind == Kind::Facets).then(|| {
            let polygons = self.parts().filter(|part| part.len() > 2);
            let polygons = polygons.map(<[u32]>::to_vec).collect();
            claimed::spatial(points, &self.vertices(), polygons)
        })
    }

    /// The layers that this stands for, if it is a list of layers.
    pub fn layers(&self, points: Points<'_, 2>) -> Option<Layers> {
        let rings = || self.parts().map(<[u32]>::to_vec).collect();
        (self.kind == Kind::Layers).then(|| claimed::layers(points, rings()))
    }

    /// The triangles, if it is a list of triangles.
    pub fn triangles(&self) -> Option<Vec<[u32; 3]>> {
        let triangles = self.parts().map(|part| part.try_into().ok());
        (self.kind == Kind::Triangles).then(|| triangles.collect())?
    }

    /// The triangulation that this stands for, if it is a list of triangles.
    pub fn triangulation(&self) -> Option<Triangulation> {
        self.triangles().map(Triangulation::new)
    }
}

impl From<&Hull2> for Answer {
    fn from(hull: &Hull2) -> Self {
        Answer::new(Kind::Cycle, [hull.vertices()])
    }
}

impl From<&Hull3> for Answer {
    fn from(hull: &Hull3) -> Self {
        match hull {
            Hull3::Empty => Answer::new::<[u32; 0]>(Kind::Facets, []),
            Hull3::Solid(solid) => Answer::new(Kind::Facets, solid.facets()),
            flat => Answer::new(Kind::Facets, [flat.vertices()]),
        }
    }
}

impl From<&Layers> for Answer {
    fn from(layers: &Layers) -> Self {
        Answer::new(Kind::Layers, layers.rings().iter().map(Hull2::vertices))
    }
}

impl From<&Triangulation> for Answer {
    fn from(triangulation: &Triangulation) -> Self {
        Answer::new(Kind::Triangles, triangulation.triangles())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn travelled(answer: &Answer, n: u32) -> Result<Answer, String> {
        let mut bytes = Vec::new();
        answer.write(&mut bytes).unwrap();
        Answer::read(answer.header(), &bytes, n)
    }

    #[test]
    fn answers_arrive_as_they_were_sent() {
        for parts in [
            vec![],
            vec![vec![]],
            vec![vec![3, 1, 2], vec![0], vec![2, 1]],
        ] {
            let answer = Answer::new(Kind::Layers, &parts);
            assert_eq!(travelled(&answer, 4), Ok(answer.clone()));
            assert_eq!(answer.parts().collect::<Vec<_>>(), parts);
        }
    }

    #[test]
    fn an_index_of_no_point_is_found() {
        let answer = Answer::new(Kind::Cycle, [[0, 1, 4]]);
        assert_eq!(travelled(&answer, 4), Err("index 4 of 4 points".into()));
    }

    #[test]
    fn lengths_that_do_not_add_up_are_found() {
        let header = HullHeader {
            kind: Kind::Cycle,
            lengths: 1,
            indices: 1,
        };
        let bytes: Vec<u8> = [2_u32, 0].iter().flat_map(|n| n.to_le_bytes()).collect();
        assert!(Answer::read(header, &bytes, 4).is_err());
    }

    #[test]
    fn every_kind_of_planar_hull_comes_back() {
        let points = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
        for (n, hull) in [
            (0, Hull2::Empty),
            (1, Hull2::Point(0)),
            (3, Hull2::Segment(vec![0, 2])),
            (3, Hull2::Segment(vec![0, 1, 2])),
            (5, Hull2::Polygon(vec![0, 2, 3])),
        ] {
            let points = Points::new(&points[..n]).unwrap();
            assert_eq!(Answer::from(&hull).hull2(points), Some(hull));
        }
    }

    #[test]
    fn every_kind_of_spatial_hull_comes_back() {
        let points = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        for n in 0..=points.len() {
            let hull = hullkit::convex_hull_3d(&points[..n]).unwrap();
            let view = Points::new(&points[..n]).unwrap();
            assert_eq!(Answer::from(&hull).hull3(view), Some(hull));
        }
    }

    #[test]
    fn layers_come_back_with_the_ranks_of_copies() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let points = [&square[..], &[[1.0, 1.0], [4.0, 4.0], [1.0, 1.0]]].concat();
        let layers = hullkit::convex_layers(&points, geometry_core::Boundary::Extreme).unwrap();
        let view = Points::new(&points).unwrap();
        assert_eq!(Answer::from(&layers).layers(view), Some(layers));
    }
}
