//! The point sets of the suite in space with their right answers, found once a process.

use super::change::{Change3, carried};
use crate::families_space;
use crate::{check, oracle};
use geometry_core::{Hull3, Point3};
use std::sync::OnceLock;

/// A point set and its right answer.
pub(super) struct Solved {
    /// The family it is of.
    pub(super) name: &'static str,
    pub(super) points: Vec<Point3>,
    pub(super) answer: Hull3,
}

impl Solved {
    fn new(name: &'static str, points: Vec<Point3>) -> Self {
        let answer = oracle::hull3(&points);
        Self {
            name,
            points,
            answer,
        }
    }

    /// The changed points with the answer carried along.
    pub(super) fn carried(&self, change: &Change3) -> Self {
        Self {
            name: self.name,
            points: change.points.clone(),
            answer: carried(&self.answer, change),
        }
    }

    /// The points and, after them, midpoints of pairs of them, as far as the checker finds that these leave the hull
    /// as it is.
    pub(super) fn grown(&self) -> Self {
        const MOST: usize = 12;
        let mut points = self.points.clone();
        for (i, p) in self.points.iter().enumerate() {
            let q = self.points[(i * 7 + 3) % self.points.len()];
            points.push([0, 1, 2].map(|axis| p[axis] / 2.0 + q[axis] / 2.0));
            if check::hull3(&points, &self.answer).is_err() {
                points.pop();
            }
            if points.len() == self.points.len() + MOST {
                break;
            }
        }
        Self {
            name: self.name,
            points,
            answer: self.answer.clone(),
        }
    }
}

/// All sets of the suite.
pub(super) struct Cases {
    /// The [families](families_space).
    pub(super) families: Vec<Solved>,
    /// The exhaustive sets.
    pub(super) small: Vec<Solved>,
}

/// All sets of the suite, solved at the first call.
pub(super) fn cases() -> &'static Cases {
    static CASES: OnceLock<Cases> = OnceLock::new();
    CASES.get_or_init(|| {
        let subsets =
            subsets_of_lattice(5).map(|points| ("subsets of a 3 x 3 x 3 lattice", points));
        let sequences =
            sequences_of_corners(5).map(|points| ("sequences of corners of a cube", points));
        Cases {
            families: families_space::all()
                .into_iter()
                .map(|family| Solved::new(family.name, family.points))
                .collect(),
            small: subsets
                .chain(sequences)
                .map(|(name, points)| Solved::new(name, points))
                .collect(),
        }
    })
}

/// Every set of at most `most` points of the 3 × 3 × 3 lattice. Which point comes first varies from set to set.
fn subsets_of_lattice(most: u32) -> impl Iterator<Item = Vec<Point3>> {
    const CELLS: u32 = 27;
    (0..=most)
        .flat_map(|size| {
            let first = (1_u32 << size) - 1;
            std::iter::successors(Some(first), |&set| next_of_same_size(set))
                .take_while(|&set| set >> CELLS == 0)
        })
        .map(|set| {
            let cells = (0..CELLS).filter(|cell| set >> cell & 1 == 1);
            let mut points: Vec<Point3> = cells
                .map(|cell| [cell % 3, cell / 3 % 3, cell / 9].map(f64::from))
                .collect();
            let turns = set as usize % points.len().max(1);
            points.rotate_left(turns);
            points
        })
}

/// The next larger number with as many bits set (Gosper's hack); none after zero.
fn next_of_same_size(set: u32) -> Option<u32> {
    let lowest = set & set.wrapping_neg();
    let ripple = set.checked_add(lowest)?;
    let ones = ((ripple ^ set) >> 2).checked_div(lowest)?;
    Some(ripple | ones)
}

/// Every sequence of 1 to `longest` corners of the unit cube: every multiset, in every order.
fn sequences_of_corners(longest: u32) -> impl Iterator<Item = Vec<Point3>> {
    (1..=longest).flat_map(|length| {
        (0..8_u32.pow(length)).map(move |number| {
            (0..length)
                .map(|place| number >> (3 * place))
                .map(|corner| [0, 1, 2].map(|axis| f64::from(corner >> axis & 1)))
                .collect()
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exhaustive_sets_are_as_many_as_counted() {
        // 1 + 27 + 351 + 2925 + 17,550 + 80,730 subsets; 8 + 64 + 512 + 4096 + 32,768 sequences.
        assert_eq!(subsets_of_lattice(5).count(), 101_584);
        assert_eq!(sequences_of_corners(5).count(), 37_448);
        let mut subsets: Vec<Vec<u64>> = subsets_of_lattice(3)
            .map(|points| {
                let mut cells: Vec<u64> = points
                    .iter()
                    .map(|p| (p[0] + 3.0 * p[1] + 9.0 * p[2]) as u64)
                    .collect();
                cells.sort_unstable();
                cells
            })
            .collect();
        subsets.sort_unstable();
        subsets.dedup();
        assert_eq!(subsets.len(), 1 + 27 + 351 + 2925);
    }
}
