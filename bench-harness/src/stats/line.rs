//! The slope of a weighted straight line, with its interval.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// A fitted line y = intercept + slope x.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Change of y with x.
    pub slope: f64,
    /// y at x = 0.
    pub intercept: f64,
    /// Standard error of the slope, from the scatter about the line.
    pub slope_error: f64,
    /// Observations less the two fitted values.
    pub freedom: f64,
}

impl Line {
    /// The interval of the slope at `confidence` (0 to 1), by Student's t.
    pub fn slope_interval(&self, confidence: f64) -> (f64, f64) {
        let quantile = StudentsT::new(0.0, 1.0, self.freedom)
            .map_or(f64::INFINITY, |t| t.inverse_cdf(0.5 + confidence / 2.0));
        let half = quantile * self.slope_error;
        (self.slope - half, self.slope + half)
    }
}

/// The least-squares line through `(x, y, weight)`; `None` for fewer than three points or a single x.
pub fn fit(data: &[(f64, f64, f64)]) -> Option<Line> {
    if data.len() < 3 {
        return None;
    }
    let total: f64 = data.iter().map(|(_, _, w)| w).sum();
    let x_mean = data.iter().map(|(x, _, w)| w * x).sum::<f64>() / total;
    let y_mean = data.iter().map(|(_, y, w)| w * y).sum::<f64>() / total;
    let spread: f64 = data.iter().map(|(x, _, w)| w * (x - x_mean).powi(2)).sum();
    if spread <= 0.0 || !spread.is_finite() {
        return None;
    }
    let slope = data
        .iter()
        .map(|(x, y, w)| w * (x - x_mean) * (y - y_mean))
        .sum::<f64>()
        / spread;
    let intercept = y_mean - slope * x_mean;
    let residual = |x: f64, y: f64| y - intercept - slope * x;
    let freedom = data.len() as f64 - 2.0;
    let squares: f64 = data
        .iter()
        .map(|&(x, y, w)| w * residual(x, y).powi(2))
        .sum();
    let slope_error = (squares / freedom / spread).sqrt();
    Some(Line {
        slope,
        intercept,
        slope_error,
        freedom,
    })
}

/// The line through (ln x, ln y), every point of the same weight: its slope is the exponent of growth.
pub fn fit_log_log(data: &[(f64, f64)]) -> Option<Line> {
    let logs: Vec<(f64, f64, f64)> = data.iter().map(|(x, y)| (x.ln(), y.ln(), 1.0)).collect();
    fit(&logs)
}

/// The line through (ln x, y), every point of the same weight, with an error of the slope that holds however
/// the spread of y changes with x.
///
/// H. White, *A heteroskedasticity-consistent covariance matrix estimator*, Econometrica 48 (1980), with the
/// factor N / (N - 2) for small N.
pub fn fit_on_log(data: &[(f64, f64)]) -> Option<Line> {
    let logs: Vec<(f64, f64, f64)> = data.iter().map(|(x, y)| (x.ln(), *y, 1.0)).collect();
    let line = fit(&logs)?;
    let x_mean = logs.iter().map(|(x, ..)| x).sum::<f64>() / logs.len() as f64;
    let spread: f64 = logs.iter().map(|(x, ..)| (x - x_mean).powi(2)).sum();
    let squares: f64 = logs
        .iter()
        .map(|(x, y, _)| ((x - x_mean) * (y - line.intercept - line.slope * x)).powi(2))
        .sum();
    let factor = logs.len() as f64 / line.freedom;
    Some(Line {
        slope_error: (factor * squares).sqrt() / spread,
        ..line
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_line() {
        // y = 1, 3, 2, 5 at x = 1, 2, 3, 4: slope 1.1, intercept 0, s² = 2.7 / 2, Sxx = 5.
        let line = fit(&[
            (1.0, 1.0, 1.0),
            (2.0, 3.0, 1.0),
            (3.0, 2.0, 1.0),
            (4.0, 5.0, 1.0),
        ])
        .expect("a line");
        assert!((line.slope - 1.1).abs() < 1e-12 && line.intercept.abs() < 1e-12);
        assert!((line.slope_error - (1.35_f64 / 5.0).sqrt()).abs() < 1e-12);
        let (low, high) = line.slope_interval(0.95);
        let half = 4.302_652_729_911_275 * line.slope_error;
        assert!((low - (1.1 - half)).abs() < 1e-6 && (high - (1.1 + half)).abs() < 1e-6);
    }

    #[test]
    fn a_power_law_has_its_exponent() {
        let data: Vec<(f64, f64)> = (1..9)
            .map(|x| (f64::from(x), 3.0 * f64::from(x).powf(1.5)))
            .collect();
        let line = fit_log_log(&data).expect("a line");
        assert!((line.slope - 1.5).abs() < 1e-12 && (line.intercept.exp() - 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_error_follows_the_spread() {
        // Spread at the two ends only: 1 at x = 1, none at x = e, 3 at x = e².
        let e = std::f64::consts::E;
        let data = [
            (1.0, 1.0),
            (1.0, -1.0),
            (e, 0.0),
            (e, 0.0),
            (e * e, 3.0),
            (e * e, -3.0),
        ];
        let line = fit_on_log(&data).expect("a line");
        assert!(line.slope.abs() < 1e-12);
        let by_hand = (6.0_f64 / 4.0 * (1.0 + 1.0 + 9.0 + 9.0)).sqrt() / 4.0;
        assert!((line.slope_error - by_hand).abs() < 1e-9, "{line:?}");
    }

    #[test]
    fn no_line_through_too_little() {
        assert!(fit(&[(1.0, 1.0, 1.0), (2.0, 2.0, 1.0)]).is_none());
        assert!(fit(&[(1.0, 1.0, 1.0); 4]).is_none());
    }
}
