//! The point sets of the suite with their right answers, found once a process.

use super::BOUNDARIES;
use super::answer::Answer;
use super::change::Change;
use crate::families;
use geometry_core::{Boundary, Point2};

/// A point set and its right answers.
pub(super) struct Solved<A> {
    /// The family it is of.
    pub(super) name: &'static str,
    pub(super) points: Vec<Point2>,
    /// In the order of [`BOUNDARIES`].
    answers: [A; 2],
}

impl<A: Answer> Solved<A> {
    fn new(name: &'static str, points: Vec<Point2>) -> Self {
        let answers = BOUNDARIES.map(|boundary| A::expected(&points, boundary));
        Self {
            name,
            points,
            answers,
        }
    }

    pub(super) fn answer(&self, boundary: Boundary) -> &A {
        match boundary {
            Boundary::Extreme => &self.answers[0],
            Boundary::All => &self.answers[1],
        }
    }

    /// The changed points with the answers carried along.
    pub(super) fn carried(&self, change: &Change) -> Self {
        Self {
            name: self.name,
            points: change.points.clone(),
            answers: [0, 1].map(|i| self.answers[i].carried(change)),
        }
    }

    /// More points whose answer follows, for this boundary only.
    pub(super) fn grown(&self, boundary: Boundary) -> Option<Self> {
        let (points, answer) = self.answer(boundary).grown(&self.points, boundary)?;
        Some(Self {
            name: self.name,
            points,
            answers: [answer.clone(), answer],
        })
    }
}

/// All sets of the suite.
pub(super) struct Cases<A> {
    /// The [families].
    pub(super) families: Vec<Solved<A>>,
    /// The exhaustive sets.
    pub(super) small: Vec<Solved<A>>,
}

/// All sets of the suite, solved at the first call.
pub(super) fn cases<A: Answer>() -> &'static Cases<A> {
    A::cache().get_or_init(|| Cases {
        families: families::all()
            .into_iter()
            .map(|family| Solved::new(family.name, family.points))
            .collect(),
        small: subsets_of_lattice(4, 6)
            .map(|points| Solved::new("subsets of a 4 x 4 lattice", points))
            .chain(
                sequences_of_lattice(3, 4)
                    .map(|points| Solved::new("sequences of a 3 x 3 lattice", points)),
            )
            .collect(),
    })
}

/// Every set of at most `most` points of the k × k lattice. Which point comes first varies from set to set.
pub(super) fn subsets_of_lattice(k: u32, most: u32) -> impl Iterator<Item = Vec<Point2>> {
    (0_u32..1 << (k * k))
        .filter(move |set| set.count_ones() <= most)
        .map(move |set| {
            let cells = (0..k * k).filter(|cell| set >> cell & 1 == 1);
            let mut points: Vec<Point2> = cells.map(|cell| lattice_point(k, cell)).collect();
            let turns = set as usize % points.len().max(1);
            points.rotate_left(turns);
            points
        })
}

/// Every sequence of 1 to `longest` points of the k × k lattice: every multiset, in every order.
fn sequences_of_lattice(k: u32, longest: u32) -> impl Iterator<Item = Vec<Point2>> {
    let cells = k * k;
    (1..=longest).flat_map(move |length| {
        (0..cells.pow(length)).map(move |number| {
            (0..length)
                .map(|place| lattice_point(k, number / cells.pow(place) % cells))
                .collect()
        })
    })
}

fn lattice_point(k: u32, cell: u32) -> Point2 {
    [f64::from(cell % k), f64::from(cell / k)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exhaustive_sets_are_as_many_as_counted() {
        // 1 + 16 + 120 + 560 + 1820 + 4368 + 8008 subsets; 9 + 81 + 729 + 6561 sequences.
        assert_eq!(subsets_of_lattice(4, 6).count(), 14_893);
        assert_eq!(sequences_of_lattice(3, 4).count(), 7_380);
    }
}
