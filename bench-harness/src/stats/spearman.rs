//! Whether one thing rises with another, in whatever shape.
//!
//! C. Spearman, *The proof and measurement of association between two things*, American J. Psychology 15 (1904).

use super::ranks;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// A rank correlation.
#[derive(Clone, Copy, Debug)]
pub struct Correlation {
    /// From -1, always falling, to 1, always rising.
    pub rho: f64,
    /// The two-sided p-value of no correlation, by Student's t.
    pub p_value: f64,
}

/// The rank correlation of `(x, y)`; `None` of fewer than four, or if either does not vary.
pub fn correlation(data: &[(f64, f64)]) -> Option<Correlation> {
    let count = data.len();
    if count < 4 {
        return None;
    }
    let [x, y] = [0, 1].map(|side| {
        let of = |pair: &(f64, f64)| if side == 0 { pair.0 } else { pair.1 };
        ranks::doubled(&data.iter().map(of).collect::<Vec<_>>())
    });
    let mean = count as f64 + 1.0;
    let product = |a: &[u64], b: &[u64]| -> f64 {
        let terms = a.iter().zip(b);
        terms
            .map(|(a, b)| (*a as f64 - mean) * (*b as f64 - mean))
            .sum()
    };
    let spread = (product(&x, &x) * product(&y, &y)).sqrt();
    if spread <= 0.0 {
        return None;
    }
    let rho = (product(&x, &y) / spread).clamp(-1.0, 1.0);
    let freedom = count as f64 - 2.0;
    let t = rho.abs() * (freedom / (1.0 - rho * rho)).sqrt();
    let tail = StudentsT::new(0.0, 1.0, freedom).ok()?.sf(t);
    let p_value = if t.is_finite() { 2.0 * tail } else { 0.0 };
    Some(Correlation { rho, p_value })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        let rho = |data: &[(f64, f64)]| correlation(data).expect("varies").rho;
        let rising: Vec<(f64, f64)> = (0..9).map(|x| (f64::from(x), f64::from(x * x))).collect();
        assert!((rho(&rising) - 1.0).abs() < 1e-15);
        // Ranks of y: 2 1 4 3 5; rho = 1 - 6 * 4 / 120.
        let swapped = [
            (1.0, 20.0),
            (2.0, 10.0),
            (3.0, 40.0),
            (4.0, 30.0),
            (5.0, 90.0),
        ];
        let found = correlation(&swapped).expect("varies");
        assert!((found.rho - 0.8).abs() < 1e-12);
        // t = 0.8 sqrt(3 / 0.36) = 2.3094 with 3 degrees of freedom.
        assert!((found.p_value - 0.104_088).abs() < 1e-5, "{found:?}");
    }

    #[test]
    fn nothing_varies_or_too_little_is_known() {
        assert!(correlation(&[(1.0, 1.0); 3]).is_none());
        assert!(correlation(&[(1.0, 2.0), (2.0, 2.0), (3.0, 2.0), (4.0, 2.0)]).is_none());
    }
}
