//! How many degrees of freedom there are about the mean of values that come in clusters.
//!
//! F. E. Satterthwaite, *An approximate distribution of estimates of variance components*, Biometrics Bulletin 2 (1946).

use super::summary::{mean, median};

/// The degrees of freedom of the scatter of the clusters' common mean: near one less than the clusters if they differ
/// much from each other, near the values less the clusters if they do not. At least 1.
///
/// ```
/// use bench_harness::stats::freedom::of_clusters;
/// let alike = vec![vec![1.0, 2.0, 3.0]; 4];
/// assert!((of_clusters(&alike) - 8.0).abs() < 1e-9);
/// let unlike = [vec![1.0, 1.001], vec![5.0, 5.001], vec![9.0, 9.001]];
/// assert!((of_clusters(&unlike) - 2.0).abs() < 1e-3);
/// ```
pub fn of_clusters(clusters: &[Vec<f64>]) -> f64 {
    let count: usize = clusters.iter().map(Vec::len).sum();
    let groups = clusters.len() as f64;
    let inner_freedom = count as f64 - groups;
    if inner_freedom < 1.0 {
        return (groups - 1.0).max(1.0);
    }
    let squares = |values: &[f64], center: f64| -> f64 {
        values.iter().map(|value| (value - center).powi(2)).sum()
    };
    let within: f64 = clusters
        .iter()
        .map(|cluster| squares(cluster, mean(cluster)))
        .sum();
    let inner = within / inner_freedom / count as f64;
    if clusters.len() < 2 {
        return inner_freedom;
    }
    let middles: Vec<f64> = clusters.iter().map(|cluster| median(cluster)).collect();
    let between = squares(&middles, mean(&middles)) / (groups - 1.0) / groups;
    let outer = (between - inner).max(0.0);
    let total = (inner + outer).powi(2);
    let freedom = total / (outer * outer / (groups - 1.0) + inner * inner / inner_freedom);
    if freedom.is_nan() {
        return inner_freedom;
    }
    freedom.max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_little_or_no_scatter() {
        assert!((of_clusters(&[vec![1.0, 2.0, 4.0]]) - 2.0).abs() < 1e-12);
        assert!((of_clusters(&[vec![1.0], vec![2.0], vec![4.0]]) - 2.0).abs() < 1e-12);
        assert!((of_clusters(&[vec![1.0; 3], vec![1.0; 3]]) - 4.0).abs() < 1e-12);
        assert!((of_clusters(&[]) - 1.0).abs() < 1e-12);
    }
}
