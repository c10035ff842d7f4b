//! Whether directed edges form one convex outline.

use crate::arithmetic::Turn;
use std::cmp::Ordering;

/// What keeps directed edges from being the outline of a convex polygon.
pub(super) enum Fault {
    /// At these vertices the edges branch, end, turn right or turn back.
    Breaks(Vec<u32>),
    /// The edges turn left or run straight on everywhere, but go round more than once, in one cycle or several.
    Winding(usize),
}

/// The faults of `edges`, in any order, as the anticlockwise outline of a convex polygon that may run straight on at
/// vertices. `turn` tells how three vertices turn, `order` compares two lexicographically.
///
/// In cycles that turn left or run straight on everywhere the direction of the edges only ever turns anticlockwise,
/// and each revolution passes one lexicographic maximum: so there is one maximum in all exactly if there is one
/// cycle and it goes round once.
///
/// O(k log k) for k edges.
pub(super) fn convex_outline(
    mut edges: Vec<[u32; 2]>,
    turn: impl Fn(u32, u32, u32) -> Turn,
    order: impl Fn(u32, u32) -> Ordering,
) -> Result<(), Fault> {
    edges.sort_unstable();
    let branching = edges.windows(2).filter(|pair| pair[0][0] == pair[1][0]);
    let mut breaks: Vec<u32> = branching.map(|pair| pair[0][0]).collect();
    let mut maxima = 0;
    for &[before, at] in &edges {
        let Ok(next) = edges.binary_search_by_key(&at, |edge| edge[0]) else {
            breaks.push(at);
            continue;
        };
        let after = edges[next][1];
        match turn(before, at, after) {
            Turn::Left => {}
            Turn::Straight if order(before, at) == order(at, after) => {}
            _ => breaks.push(at),
        }
        maxima += usize::from(order(before, at).is_lt() && order(after, at).is_lt());
    }
    breaks.sort_unstable();
    breaks.dedup();
    if !breaks.is_empty() {
        Err(Fault::Breaks(breaks))
    } else if maxima != 1 {
        Err(Fault::Winding(maxima))
    } else {
        Ok(())
    }
}
