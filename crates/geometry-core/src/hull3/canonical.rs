//! The canonical order of facets, in linear time where they are triangles.
//!
//! Facets are sorted by their smallest index, their *first* corner, and then by the corner after it; no two facets of a
//! surface share both.
//!
//! 1. Triangles are dealt into piles by the high bits of their first corner, so few that each pile grows in the cache.
//! 2. In a pile they are dealt into a bucket for each first corner. A surface has fewer than twice as many triangles as
//!    corners, so a bucket holds two on average, and these are sorted by the second corner.
//! 3. Larger facets, of which there are few or many but each worth several triangles, are sorted by comparison, and the
//!    two rows are merged.
//!
//! Where indices are few, triangles are dealt by the second corner, and then, in that order, by the first, instead of steps 1 and 2:
//! nothing is compared.

use super::facets::Loops;
use crate::triangulation::order::place_by_key;
use std::iter::once;

/// Of so many indices at most, triangles are dealt by both corners: two rows of counters fit the second cache.
const SMALL: usize = 1 << 15;

/// The most piles: as many as have the line they grow at in the fastest cache.
const PILES: u32 = 256;

/// So many first corners, or all, share a pile at least.
const SMALLEST: u32 = 2048;

/// The most triangles of a bucket that are sorted by insertion.
const FEW: u32 = 16;

/// The triangles that `triangles` yields, the same ones in every call, and the facets `larger`, all with indices below
/// `count` and starting anywhere, in canonical order.
///
/// # Cost
///
/// O(count + t) for t triangles of a surface, O(m log m) for larger facets of m corners in all.
pub(super) fn in_order<I: Iterator<Item = [u32; 3]>>(
    count: usize,
    triangles: impl Fn() -> I,
    larger: Loops,
) -> Loops {
    let corners = sorted_triangles(count, triangles);
    if larger.len() == 0 {
        return Loops::of_triangles(corners);
    }
    merged(&corners, sorted(larger))
}

/// Steps 1 and 2, unless indices are few.
fn sorted_triangles<I: Iterator<Item = [u32; 3]>>(
    count: usize,
    triangles: impl Fn() -> I,
) -> Vec<[u32; 3]> {
    if count <= SMALL {
        return dealt_twice(count, triangles());
    }
    // The first corners of a pile differ in this many low bits.
    let low_bits = ((count as u32 / PILES).max(SMALLEST.min(count as u32)) + 1).ilog2() + 1;
    let mut places = vec![0; (count >> low_bits) + 1];
    for [a, b, c] in triangles() {
        places[(a.min(b).min(c) >> low_bits) as usize] += 1;
    }
    let mut dealt = vec![[0; 3]; add_up(&mut places) as usize];
    for triangle in triangles() {
        let triangle = from_smallest(triangle);
        let place = &mut places[(triangle[0] >> low_bits) as usize];
        dealt[*place as usize] = triangle;
        *place += 1;
    }
    // Each place has moved from where its pile begins to where it ends.
    let mut copy = Vec::new();
    let mut buckets = vec![0; 1 << low_bits];
    let mut start = 0;
    for end in places {
        sort_pile(&mut dealt[start..end as usize], &mut buckets, &mut copy);
        start = end as usize;
    }
    dealt
}

/// Deals triangles by their second corner, and then, in that order, by their first: without a branch.
fn dealt_twice(count: usize, triangles: impl Iterator<Item = [u32; 3]>) -> Vec<[u32; 3]> {
    let mut sorted: Vec<[u32; 3]> = triangles.map(from_smallest).collect();
    let mut dealt = vec![[0; 3]; sorted.len()];
    place_by_key(|| once(&sorted[..]), &mut dealt, count, |t| t[1] as usize);
    place_by_key(|| once(&dealt[..]), &mut sorted, count, |t| t[0] as usize);
    sorted
}

/// Turns sizes into where each begins; returns the total.
fn add_up(sizes: &mut [u32]) -> u32 {
    let mut total = 0;
    for size in sizes {
        total += std::mem::replace(size, total);
    }
    total
}

/// Without a branch, as which corner is the smallest is as good as random.
fn from_smallest([a, b, c]: [u32; 3]) -> [u32; 3] {
    let second = usize::from(b < a);
    let third = usize::from(c < a.min(b));
    let first = second * (1 - third) + 2 * third;
    let twice = [a, b, c, a, b];
    [twice[first], twice[first + 1], twice[first + 2]]
}

/// Step 2. The first corners of `pile` differ in their low bits alone, of which there are as many as tell `buckets`
/// apart.
fn sort_pile(pile: &mut [[u32; 3]], buckets: &mut [u32], copy: &mut Vec<[u32; 3]>) {
    let mask = buckets.len() - 1;
    buckets.fill(0);
    for triangle in &*pile {
        buckets[triangle[0] as usize & mask] += 1;
    }
    let largest = buckets.iter().copied().max().unwrap_or(0);
    add_up(buckets);
    copy.clear();
    copy.extend_from_slice(pile);
    for triangle in &*copy {
        let place = &mut buckets[triangle[0] as usize & mask];
        pile[*place as usize] = *triangle;
        *place += 1;
    }
    if largest <= FEW {
        sort_by_insertion(pile);
    } else {
        for bucket in pile.chunk_by_mut(|a, b| a[0] == b[0]) {
            bucket.sort_unstable();
        }
    }
}

/// Sorts triangles that need not move far.
fn sort_by_insertion(triangles: &mut [[u32; 3]]) {
    let key =
        |[first, second, third]: [u32; 3]| ((u64::from(first) << 32) | u64::from(second), third);
    for i in 1..triangles.len() {
        let triangle = triangles[i];
        let mut place = i;
        while place > 0 && key(triangles[place - 1]) > key(triangle) {
            triangles[place] = triangles[place - 1];
            place -= 1;
        }
        triangles[place] = triangle;
    }
}

/// Step 3.
fn merged(triangles: &[[u32; 3]], larger: Loops) -> Loops {
    let mut all = Loops::with_capacity(
        triangles.len() + larger.len(),
        3 * triangles.len() + larger.corners.len(),
    );
    let mut facets = (0..larger.len()).map(|i| larger.polygon(i)).peekable();
    for triangle in triangles {
        while let Some(facet) = facets.next_if(|facet| *facet < &triangle[..]) {
            all.push(facet);
        }
        all.push(triangle);
    }
    facets.for_each(|facet| all.push(facet));
    all
}

/// The facets, starting anywhere and in any order, in canonical order: by the first two corners side by side in memory.
pub(super) fn sorted(mut facets: Loops) -> Loops {
    let mut order: Vec<(u64, u32)> = Vec::with_capacity(facets.len());
    for i in 0..facets.len() {
        let range = facets.range(i);
        let corners = &mut facets.corners[range];
        let first = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap_or(0);
        corners.rotate_left(first);
        let [first, second] = [0, 1].map(|i| u64::from(corners.get(i).copied().unwrap_or(0)));
        order.push((first << 32 | second, i as u32));
    }
    let corners = |i: u32| facets.polygon(i as usize);
    order.sort_unstable_by(|(key, i), (other, j)| {
        key.cmp(other).then_with(|| corners(*i).cmp(corners(*j)))
    });
    let mut sorted = Loops::with_capacity(facets.len(), facets.corners.len());
    for &(_, i) in &order {
        sorted.push(corners(i));
    }
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn facets(loops: &Loops) -> Vec<&[u32]> {
        (0..loops.len()).map(|i| loops.polygon(i)).collect()
    }

    #[test]
    fn triangles_and_larger_facets_are_merged_in_order() {
        let triangles = [[7, 2, 5], [5, 6, 0], [6, 1, 0], [2, 7, 1]];
        let mut larger = Loops::with_capacity(2, 9);
        larger.push(&[4, 3, 0, 5]);
        larger.push(&[6, 4, 5, 7, 3]);
        let all = in_order(8, || triangles.into_iter(), larger);
        let expected: [&[u32]; 6] = [
            &[0, 5, 4, 3],
            &[0, 5, 6],
            &[0, 6, 1],
            &[1, 2, 7],
            &[2, 5, 7],
            &[3, 6, 4, 5, 7],
        ];
        assert_eq!(facets(&all), expected);
    }

    /// More than one pile, and buckets from empty to large.
    #[test]
    fn triangles_are_sorted_as_by_comparison() {
        for count in [40, 255, 256, 257, 5000, 40_000_u32] {
            // Distinct corners, anywhere.
            let corner = |i: u32| (u64::from(i).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as u32;
            // No two with the same first two corners, as on a surface.
            let mut seen = HashSet::new();
            let triangles = (0..2 * count).map(|i| {
                let a = corner(i) % count;
                let b = (a + 1 + corner(2 * i) % (count / 2)) % count;
                [a, b, (b + 1 + corner(3 * i) % (count / 4)) % count]
            });
            let triangles = triangles.filter(|&triangle| {
                let [first, second, _] = from_smallest(triangle);
                seen.insert([first, second])
            });
            let triangles: Vec<[u32; 3]> = triangles.collect();
            let mut expected = Loops::with_capacity(0, 0);
            triangles
                .iter()
                .for_each(|triangle| expected.push(triangle));
            let expected = sorted(expected);
            let all = in_order(
                count as usize,
                || triangles.iter().copied(),
                Loops::with_capacity(0, 0),
            );
            assert_eq!(facets(&all), facets(&expected), "{count}");
            assert_eq!(all.len(), triangles.len());
        }
    }
}
