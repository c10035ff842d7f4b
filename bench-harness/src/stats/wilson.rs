//! An interval for a proportion that stays honest at 0 and at 1.
//!
//! E. B. Wilson, *Probable inference, the law of succession, and statistical inference*, JASA 22 (1927).

/// The 95 % normal quantile used by [`interval`].
const Z: f64 = 1.959_963_984_540_054;

/// The 95 % interval of the true proportion when `hits` of `trials` were seen; (0, 1) for no trials.
pub fn interval(hits: usize, trials: usize) -> (f64, f64) {
    if trials == 0 {
        return (0.0, 1.0);
    }
    let n = trials as f64;
    let share = hits as f64 / n;
    let center = share + Z * Z / (2.0 * n);
    let half = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt();
    let scale = 1.0 + Z * Z / n;
    (
        ((center - half) / scale).max(0.0),
        ((center + half) / scale).min(1.0),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        let (low, high) = interval(8, 10);
        assert!(
            (low - 0.4902).abs() < 5e-5 && (high - 0.9433).abs() < 5e-5,
            "{low} {high}"
        );
        let (low, high) = interval(0, 100);
        assert!(
            low.abs() < 1e-12 && (high - 0.0370).abs() < 5e-5,
            "{low} {high}"
        );
        assert_eq!(interval(0, 0), (0.0, 1.0));
    }
}
