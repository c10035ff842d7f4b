//! Where a share of successes falls to a half: logistic regression on grouped trials.
//!
//! Firth's penalty keeps the estimate finite where successes and failures are separated, as they often are when few
//! values of x lie on the slope.
//!
//! D. Firth, *Bias reduction of maximum likelihood estimates*, Biometrika 80 (1993).

/// A fitted logistic curve: the share at x is 1 / (1 + exp(-slope (x - half))).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Logistic {
    pub(crate) slope: f64,
    /// The x at which the share is a half.
    pub(crate) half: f64,
    /// Its standard error, by the delta method.
    pub(crate) half_error: f64,
}

/// Newton's steps before the fit is given up.
const STEPS: usize = 200;

/// No step moves the linear predictor by more than this, in units of the spread of x.
const LONGEST: f64 = 2.0;

/// The curve through `(x, successes, trials)`; `None` without two values of x, without a success or without a failure,
/// or if the fit does not settle.
pub(crate) fn fit(data: &[(f64, usize, usize)]) -> Option<Logistic> {
    let successes: usize = data.iter().map(|(_, k, _)| k).sum();
    let trials: usize = data.iter().map(|(.., n)| n).sum();
    if successes == 0 || successes == trials {
        return None;
    }
    // x is shifted to its mean, so that intercept and slope are nearly independent.
    let centre = data.iter().map(|(x, _, n)| x * *n as f64).sum::<f64>() / trials as f64;
    let shifted: Vec<(f64, f64, f64)> = data
        .iter()
        .map(|&(x, k, n)| (x - centre, k as f64, n as f64))
        .collect();
    let spread = shifted.iter().map(|(x, ..)| x.abs()).fold(0.0, f64::max);
    if spread <= 0.0 {
        return None;
    }
    let (mut a, mut b) = (0.0, 0.0);
    for _ in 0..STEPS {
        let information = Information::at(&shifted, a, b);
        let [[aa, ab], [_, bb]] = information.inverse()?;
        let (mut u, mut v) = (0.0, 0.0);
        for &(x, k, n) in &shifted {
            let p = share(a + b * x);
            let weight = n * p * (1.0 - p);
            let leverage = weight * (aa + 2.0 * ab * x + bb * x * x);
            let residual = k - n * p + leverage * (0.5 - p);
            (u, v) = (u + residual, v + residual * x);
        }
        let (mut da, mut db) = (aa * u + ab * v, ab * u + bb * v);
        let length = da.abs() + (db * spread).abs();
        if length > LONGEST {
            (da, db) = (da * LONGEST / length, db * LONGEST / length);
        }
        (a, b) = (a + da, b + db);
        if length < 1e-9 {
            let [[aa, ab], [_, bb]] = Information::at(&shifted, a, b).inverse()?;
            let half = -a / b;
            let variance = (aa + 2.0 * half * ab + half * half * bb) / (b * b);
            return Some(Logistic {
                slope: b,
                half: half + centre,
                half_error: variance.max(0.0).sqrt(),
            });
        }
    }
    None
}

/// Fisher's information on intercept and slope.
struct Information {
    sum: f64,
    of_x: f64,
    of_square: f64,
}

impl Information {
    fn at(data: &[(f64, f64, f64)], a: f64, b: f64) -> Self {
        let (mut sum, mut of_x, mut of_square) = (0.0, 0.0, 0.0);
        for &(x, _, n) in data {
            let p = share(a + b * x);
            let weight = n * p * (1.0 - p);
            (sum, of_x, of_square) = (sum + weight, of_x + weight * x, of_square + weight * x * x);
        }
        Self {
            sum,
            of_x,
            of_square,
        }
    }

    fn inverse(&self) -> Option<[[f64; 2]; 2]> {
        let determinant = self.sum * self.of_square - self.of_x * self.of_x;
        let off = -self.of_x / determinant;
        (determinant > 0.0 && determinant.is_finite()).then(|| {
            [
                [self.of_square / determinant, off],
                [off, self.sum / determinant],
            ]
        })
    }
}

fn share(linear: f64) -> f64 {
    1.0 / (1.0 + (-linear).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_trials_give_the_curve_back() {
        let data: Vec<(f64, usize, usize)> = (0..12)
            .map(|i| {
                let x = f64::from(i);
                (
                    x,
                    (1e6 * share(1.5 * (6.25 - x))).round() as usize,
                    1_000_000,
                )
            })
            .collect();
        let curve = fit(&data).expect("a curve");
        assert!((curve.half - 6.25).abs() < 1e-3, "{curve:?}");
        assert!((curve.slope + 1.5).abs() < 1e-3, "{curve:?}");
        assert!(curve.half_error < 1e-2);
    }

    #[test]
    fn separated_shares_fall_between_the_last_success_and_the_first_failure() {
        let data: Vec<(f64, usize, usize)> = (0..12)
            .map(|i| (f64::from(i), if i < 5 { 20 } else { 0 }, 20))
            .collect();
        let curve = fit(&data).expect("a curve");
        assert!((4.0..=5.0).contains(&curve.half), "{curve:?}");
        assert!(curve.half_error > 0.0 && curve.half_error < 1.0);
    }

    #[test]
    fn nothing_falls_where_all_are_alike() {
        assert!(fit(&[(1.0, 5, 5), (2.0, 5, 5)]).is_none());
        assert!(fit(&[(1.0, 0, 5), (2.0, 0, 5)]).is_none());
        assert!(fit(&[(1.0, 2, 5)]).is_none());
        assert!(fit(&[]).is_none());
    }
}
