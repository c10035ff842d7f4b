//! Many tests at once.
//!
//! S. Holm, *A simple sequentially rejective multiple test procedure*, Scand. J. Statistics 6 (1979).

/// The p-values adjusted so that rejecting those below α errs in any of them with probability at most α.
pub fn adjusted(p_values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_unstable_by(|&i, &j| p_values[i].total_cmp(&p_values[j]));
    let mut adjusted = vec![0.0; p_values.len()];
    let mut largest: f64 = 0.0;
    for (place, &i) in order.iter().enumerate() {
        largest = largest
            .max(p_values[i] * (p_values.len() - place) as f64)
            .min(1.0);
        adjusted[i] = largest;
    }
    adjusted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        let here = adjusted(&[0.01, 0.04, 0.03, 0.005]);
        for (got, known) in here.iter().zip([0.03, 0.06, 0.06, 0.02]) {
            assert!((got - known).abs() < 1e-12, "{here:?}");
        }
        assert!(adjusted(&[]).is_empty());
    }
}
