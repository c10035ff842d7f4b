//! The canonical order of facets, in linear time where they are triangles.
//!
//! Facets are sorted by their smallest index, their *first* corner, and then by the corner after it; no two facets of a
//! surface share both.
//!
//! 1. Triangles are dealt into one bucket for each first corner (a counting sort). A surface has fewer than twice as
//!    many triangles as corners, so a bucket holds two on average, and these are sorted by the second corner. A triangle
//!    is two words in its bucket: its second and third corner.
//! 2. Larger facets, of which there are few or many but each worth several triangles, are sorted by comparison.
//! 3. The two rows are merged.

use super::facets::Loops;

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
    let (ends, mut dealt) = deal(count, triangles);
    let larger = sorted(larger);
    let mut all = Loops::with_capacity(
        dealt.len() + larger.len(),
        3 * dealt.len() + larger.corners.len(),
    );
    let mut larger = (0..larger.len())
        .map(|i| &larger.corners[larger.range(i)])
        .peekable();
    let mut start = 0;
    for (first, end) in (0..).zip(ends) {
        let bucket = &mut dealt[start as usize..end as usize];
        start = end;
        bucket.sort_unstable();
        for &mut rest in bucket {
            let triangle = [first, (rest >> 32) as u32, rest as u32];
            while let Some(facet) = larger.next_if(|facet| *facet < &triangle[..]) {
                all.push(facet);
            }
            all.push(&triangle);
        }
    }
    larger.for_each(|facet| all.push(facet));
    all
}

/// Step 1: the triangles of first corner 0, then those of first corner 1, and so on, each as its second and third
/// corner; and where the triangles of each first corner end.
fn deal<I: Iterator<Item = [u32; 3]>>(
    count: usize,
    triangles: impl Fn() -> I,
) -> (Vec<u32>, Vec<u64>) {
    let mut places = vec![0_u32; count];
    for corners in triangles() {
        let [a, b, c] = corners;
        places[a.min(b).min(c) as usize] += 1;
    }
    // From the size of each bucket to where it begins.
    let mut total = 0;
    for place in &mut places {
        let size = *place;
        *place = total;
        total += size;
    }
    let mut dealt = vec![0; total as usize];
    for [a, b, c] in triangles() {
        let [first, second, third] = if a < b && a < c {
            [a, b, c]
        } else if b < c {
            [b, c, a]
        } else {
            [c, a, b]
        };
        let place = &mut places[first as usize];
        dealt[*place as usize] = u64::from(second) << 32 | u64::from(third);
        *place += 1;
    }
    // Each place has moved from where its bucket begins to where it ends.
    (places, dealt)
}

/// Step 2, by the first two corners side by side in memory.
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
    let corners = |i: u32| &facets.corners[facets.range(i as usize)];
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

    #[test]
    fn triangles_and_larger_facets_are_merged_in_order() {
        let triangles = [[7, 2, 5], [5, 6, 0], [6, 1, 0], [2, 7, 1]];
        let mut larger = Loops::with_capacity(2, 9);
        larger.push(&[4, 3, 0, 5]);
        larger.push(&[6, 4, 5, 7, 3]);
        let all = in_order(8, || triangles.into_iter(), larger);
        let facets: Vec<&[u32]> = (0..all.len()).map(|i| &all.corners[all.range(i)]).collect();
        let expected: [&[u32]; 6] = [
            &[0, 5, 4, 3],
            &[0, 5, 6],
            &[0, 6, 1],
            &[1, 2, 7],
            &[2, 5, 7],
            &[3, 6, 4, 5, 7],
        ];
        assert_eq!(facets, expected);
    }
}
