//! How alike two orders are.
//!
//! M. G. Kendall, *A new measure of rank correlation*, Biometrika 30 (1938); tau-b, which allows for ties.

/// Kendall's tau-b of two lists of scores of the same things: 1 for the same order, -1 for the reverse.
///
/// NaN if either list has no two different scores.
pub fn tau(left: &[f64], right: &[f64]) -> f64 {
    let (mut agree, mut tied_left, mut tied_right, mut pairs) = (0.0, 0.0, 0.0, 0.0);
    let count = left.len().min(right.len());
    for i in 0..count {
        for j in i + 1..count {
            let step = |scores: &[f64]| match scores[i].total_cmp(&scores[j]) {
                std::cmp::Ordering::Less => -1.0,
                std::cmp::Ordering::Equal => 0.0,
                std::cmp::Ordering::Greater => 1.0,
            };
            let (a, b): (f64, f64) = (step(left), step(right));
            agree += a * b;
            tied_left += 1.0 - a.abs();
            tied_right += 1.0 - b.abs();
            pairs += 1.0;
        }
    }
    agree / ((pairs - tied_left) * (pairs - tied_right)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        assert!((tau(&[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0]) - 1.0).abs() < 1e-15);
        assert!((tau(&[1.0, 2.0, 3.0], &[6.0, 5.0, 4.0]) + 1.0).abs() < 1e-15);
        let one_swap = tau(&[1.0, 2.0, 3.0, 4.0], &[1.0, 3.0, 2.0, 4.0]);
        assert!((one_swap - 4.0 / 6.0).abs() < 1e-15);
        let with_ties = tau(&[12.0, 2.0, 1.0, 12.0, 2.0], &[1.0, 4.0, 7.0, 1.0, 0.0]);
        assert!((with_ties + 0.471_404_520_791_031_7).abs() < 1e-12);
        assert!(tau(&[1.0, 1.0], &[1.0, 2.0]).is_nan());
    }
}
