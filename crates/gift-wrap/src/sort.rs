//! A merge sort that any kernel can be trusted with.
//!
//! The standard library's sorts may panic when a comparison is not a total order, and the order of angles that
//! a rounded kernel gives need not be one. This one then gives some order. It is stable, and the number of
//! comparisons depends on nothing but the input, not on the version of the compiler.

use std::cmp::Ordering;

/// Sorts `ids` by `compare`, keeping equal ones in their order.
///
/// # Cost
///
/// At most n ⌈log₂ n⌉ comparisons; space for n more ids.
pub(crate) fn merge_sort(ids: &mut Vec<u32>, compare: impl Fn(u32, u32) -> Ordering) {
    let mut merged = Vec::with_capacity(ids.len());
    let mut width = 1;
    while width < ids.len() {
        for pair in ids.chunks(2 * width) {
            let (left, right) = pair.split_at(width.min(pair.len()));
            merge(left, right, &compare, &mut merged);
        }
        std::mem::swap(ids, &mut merged);
        merged.clear();
        width *= 2;
    }
}

fn merge(
    mut left: &[u32],
    mut right: &[u32],
    compare: &impl Fn(u32, u32) -> Ordering,
    merged: &mut Vec<u32>,
) {
    while let ([a, after_a @ ..], [b, after_b @ ..]) = (left, right) {
        if compare(*b, *a) == Ordering::Less {
            merged.push(*b);
            right = after_b;
        } else {
            merged.push(*a);
            left = after_a;
        }
    }
    merged.extend_from_slice(left);
    merged.extend_from_slice(right);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_and_keeps_the_order_of_equals() {
        for count in 0..40 {
            let mut ids: Vec<u32> = (0..count).map(|i| i * 7 % 40).collect();
            let mut expected = ids.clone();
            expected.sort_by_key(|id| id / 4);
            merge_sort(&mut ids, |a, b| (a / 4).cmp(&(b / 4)));
            assert_eq!(ids, expected);
        }
    }

    #[test]
    fn survives_a_comparison_that_makes_no_sense() {
        for answer in [Ordering::Less, Ordering::Greater] {
            let mut ids: Vec<u32> = (0..100).collect();
            merge_sort(&mut ids, |_, _| answer);
            ids.sort_unstable();
            assert_eq!(ids, (0..100).collect::<Vec<u32>>());
        }
    }
}
