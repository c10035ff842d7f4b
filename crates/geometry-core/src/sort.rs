//! A merge sort that no comparison can upset.
//!
//! The standard library's sorts may panic when the comparison is not a total order, and a rounded kernel's
//! need not be one. This sort looks at no answer twice: contradictory answers cost the order, nothing else. And
//! the number of comparisons depends on the input alone, not on the version of the standard library, so that
//! counts are equal everywhere.
//!
//! Bottom-up: runs of eight by insertion, then merges of neighbouring runs, back and forth between the ids
//! and a scratch slice of the same length. Stable. O(m log m) comparisons for m ids.

use std::cmp::Ordering;

/// Length of the runs that are sorted by insertion.
const RUN: usize = 8;

/// Sorts `ids` stably by `compare`, using the first `ids.len()` elements of `scratch`.
///
/// # Cost
///
/// O(m log m) comparisons for m ids; no allocation.
///
/// # Panics
///
/// If `scratch` is shorter than `ids`.
/// ```
/// let mut ids = [3, 1, 2, 0];
/// geometry_core::sort::merge_sort(&mut ids, &mut [0; 4], |a, b| (b / 2).cmp(&(a / 2)));
/// assert_eq!(ids, [3, 2, 1, 0]);
/// ```
pub fn merge_sort(
    ids: &mut [u32],
    scratch: &mut [u32],
    mut compare: impl FnMut(u32, u32) -> Ordering,
) {
    let scratch = &mut scratch[..ids.len()];
    for run in ids.chunks_mut(RUN) {
        insertion_sort(run, &mut compare);
    }
    let mut width = RUN;
    while width < ids.len() {
        let pairs = ids.chunks(2 * width).zip(scratch.chunks_mut(2 * width));
        for (pair, merged) in pairs {
            let (left, right) = pair.split_at(width.min(pair.len()));
            merge(left, right, merged, &mut compare);
        }
        ids.copy_from_slice(scratch);
        width *= 2;
    }
}

fn insertion_sort(run: &mut [u32], compare: &mut impl FnMut(u32, u32) -> Ordering) {
    for sorted in 1..run.len() {
        let id = run[sorted];
        let mut place = sorted;
        while place > 0 && compare(run[place - 1], id).is_gt() {
            run[place] = run[place - 1];
            place -= 1;
        }
        run[place] = id;
    }
}

fn merge(
    left: &[u32],
    right: &[u32],
    merged: &mut [u32],
    compare: &mut impl FnMut(u32, u32) -> Ordering,
) {
    let (mut l, mut r) = (0, 0);
    for place in merged {
        let from_right = l == left.len() || (r < right.len() && compare(left[l], right[r]).is_gt());
        if from_right {
            *place = right[r];
            r += 1;
        } else {
            *place = left[l];
            l += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::merge_sort;
    use std::cmp::Ordering;

    fn permuted(len: u32) -> Vec<u32> {
        (0..len).map(|i| i.wrapping_mul(7919) % 101).collect()
    }

    #[test]
    fn sorts_every_length_stably() {
        for len in 0..200 {
            let keys = permuted(len);
            let mut ids: Vec<u32> = (0..len).collect();
            let mut expected = ids.clone();
            expected.sort_by_key(|&id| keys[id as usize]);
            merge_sort(&mut ids, &mut vec![0; len as usize], |a, b| {
                keys[a as usize].cmp(&keys[b as usize])
            });
            assert_eq!(ids, expected);
        }
    }

    #[test]
    fn keeps_every_id_whatever_the_answers() {
        let answers = [Ordering::Greater, Ordering::Less, Ordering::Equal];
        for len in 0..200_usize {
            let mut asked = len;
            let mut ids: Vec<u32> = (0..len as u32).collect();
            merge_sort(&mut ids, &mut vec![0; len], |_, _| {
                asked = asked.wrapping_mul(31).wrapping_add(7);
                answers[asked / 8 % 3]
            });
            ids.sort_unstable();
            assert!(ids.iter().copied().eq(0..len as u32));
        }
    }
}
