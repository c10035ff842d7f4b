//! The hull of three or four points, from the turns of their triples alone.
//!
//! ```text
//!       3 ---- 2                           2
//!       |      |                          / \
//!       |      |                         / 3 \
//!       0 ---- 1                        0 --- 1
//!
//!     012, 013, 023, 123 to the left    023 to the right, the others to the left
//!     0 → 1 → 2 → 3 → 0                 0 → 1 → 2 → 0
//! ```
//!
//! An edge i → j is on the hull, anticlockwise, if all others are to its left. So the turns tell which point follows which,
//! and for four points there are sixteen cases, made into a table. There is no sort, and no branch that is a coin toss: these
//! take longer than all the rest.

use geometry_core::{Kernel2, Point2, Sign};

/// The places of the corners, anticlockwise from the lexicographically smallest; none if these are not three or four points,
/// or if three of them are collinear, which copies are.
pub(super) fn corners<K: Kernel2>(points: &[Point2], kernel: &K) -> Option<Vec<u32>> {
    match *points {
        [a, b, c] => of_three([a, b, c], kernel),
        [a, b, c, d] => of_four([a, b, c, d], kernel),
        _ => None,
    }
}

fn of_three<K: Kernel2>(points: [Point2; 3], kernel: &K) -> Option<Vec<u32>> {
    let [a, b, c] = points;
    let turn = kernel.orient(a, b, c);
    if turn.is_zero() || has_copies(&points) {
        return None;
    }
    let step = 1 + u32::from(turn.is_negative());
    let first = first(&points);
    Some(
        [0, step, 2 * step]
            .map(|steps| (first + steps) % 3)
            .to_vec(),
    )
}

fn of_four<K: Kernel2>(points: [Point2; 4], kernel: &K) -> Option<Vec<u32>> {
    let [a, b, c, d] = points;
    let turns =
        [[a, b, c], [a, b, d], [a, c, d], [b, c, d]].map(|[p, q, r]| kernel.orient(p, q, r));
    if turns.iter().any(|turn| turn.is_zero()) || has_copies(&points) {
        return None;
    }
    let next = FOLLOWING[case(turns)];
    let first = first(&points);
    let follows = |place: u32| u32::from(next[place as usize]);
    let second = follows(first);
    // Only a kernel that is not exact can say so of the lexicographically smallest.
    if second == u32::from(NONE) {
        return None;
    }
    let third = follows(second);
    let fourth = follows(third);
    let mut corners = vec![first, second, third, fourth];
    corners.truncate(3 + usize::from(fourth != first));
    Some(corners)
}

/// Whether two are equal. A kernel that is not exact may see turns all the same.
fn has_copies<const N: usize>(points: &[Point2; N]) -> bool {
    (1..N).any(|place| points[..place].contains(&points[place]))
}

/// The place of the lexicographically smallest.
fn first<const N: usize>(points: &[Point2; N]) -> u32 {
    let (mut first, mut least) = (0, points[0]);
    for (place, &p) in (1..).zip(&points[1..]) {
        let is_less = (p[0] < least[0]) | (p[0] == least[0]) & (p[1] < least[1]);
        (first, least) = if is_less { (place, p) } else { (first, least) };
    }
    first
}

/// The number of the case: bit i for a turn i to the left.
fn case(turns: [Sign; 4]) -> usize {
    let bits = turns.map(|turn| usize::from(turn.is_positive()));
    bits[0] | bits[1] << 1 | bits[2] << 2 | bits[3] << 3
}

/// No point follows: a point is inside, or no points of the plane have such turns.
const NONE: u8 = u8::MAX;

/// For each case and each point, the one that follows it on the hull.
const FOLLOWING: [[u8; 4]; 16] = {
    let mut table = [[NONE; 4]; 16];
    let mut place = 0;
    while place < 16 * 4 * 4 {
        let (case, from, to) = (place / 16, place / 4 % 4, place % 4);
        if from != to && is_edge(case, from, to) {
            table[case][from] = to as u8;
        }
        place += 1;
    }
    table
};

/// Whether both other points are to the left of from → to.
const fn is_edge(case: usize, from: usize, to: usize) -> bool {
    let mut other = 0;
    while other < 4 {
        if other != from && other != to && !is_left(case, [from, to, other]) {
            return false;
        }
        other += 1;
    }
    true
}

/// Whether the turn of three distinct points is to the left.
const fn is_left(case: usize, [i, j, k]: [usize; 3]) -> bool {
    // The triples ascend, so the one without 3 comes first and the one without 0 last.
    let missing = 6 - i - j - k;
    let ascending_is_left = case >> (3 - missing) & 1 == 1;
    let is_odd = (i > j) ^ (i > k) ^ (j > k);
    ascending_is_left ^ is_odd
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::Exact;

    /// In the table, what follows what goes round three or four corners, but for the two cases that no points of the plane have:
    /// one where every point is on the other side of each triangle.
    #[test]
    fn every_case_goes_round() {
        let mut impossible = 0;
        for next in FOLLOWING {
            let Some(start) = (0..4).find(|&i| next[i] != NONE) else {
                impossible += 1;
                continue;
            };
            let follow = |place: usize| usize::from(next[place]);
            let [second, third, fourth] = {
                let second = follow(start);
                let third = follow(second);
                [second, third, follow(third)]
            };
            assert!(second != start && third != start && third != second);
            assert!(fourth == start || follow(fourth) == start);
        }
        assert_eq!(impossible, 2);
    }

    /// All fours of a small lattice: corners are to the left of every edge, and nothing is said where three are collinear.
    #[test]
    fn all_others_are_to_the_left() {
        let lattice: Vec<Point2> = (0..12).map(|i| [i % 4, i / 4].map(f64::from)).collect();
        let mut found = 0;
        for number in 0..12_usize.pow(4) {
            let points = [0, 1, 2, 3].map(|axis| lattice[number / 12_usize.pow(axis) % 12]);
            let Some(corners) = corners(&points, &Exact) else {
                continue;
            };
            found += 1;
            let next = corners.iter().cycle().skip(1);
            for (&from, &to) in corners.iter().zip(next) {
                for other in (0..4).filter(|&other| other != from && other != to) {
                    let [a, b, p] = [from, to, other].map(|place| points[place as usize]);
                    assert!(
                        Exact.orient(a, b, p).is_positive(),
                        "{points:?} {corners:?}"
                    );
                }
            }
            let least = points
                .iter()
                .min_by(|p, q| p.partial_cmp(q).expect("numbers"));
            assert_eq!(Some(&points[corners[0] as usize]), least);
        }
        assert!(found > 1_000);
    }
}
