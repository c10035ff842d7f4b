//! What an interval says about a target, and an estimate about a margin.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Where an interval lies relative to a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// All of it within the band: equivalent to the target.
    Within,
    /// All of it outside the band: different from the target.
    Outside,
    /// Across an end of the band: undecided.
    Across,
}

/// Two one-sided tests in one look: the place of `interval` (at 90 %, for tests at 5 %) relative to the band
/// `target` ± `margin`. An interval with an end that is NaN decides nothing.
///
/// D. J. Schuirmann, *A comparison of the two one-sided tests procedure and the power approach*, J.
/// Pharmacokinetics and Biopharmaceutics 15 (1987).
pub fn equivalence(interval: (f64, f64), target: f64, margin: f64) -> Place {
    let (low, high) = (interval.0 - target, interval.1 - target);
    if low >= -margin && high <= margin {
        Place::Within
    } else if low > margin || high < -margin {
        Place::Outside
    } else {
        Place::Across
    }
}

/// The p-value of the hypothesis that a true value lies within `margin` of 0, on whichever side `estimate` lies, by
/// Student's t with `freedom`; doubled, because the side was not chosen beforehand. 1 for an estimate within the margin.
///
/// ```
/// use bench_harness::stats::interval::p_beyond;
/// assert!(p_beyond(0.30, 0.01, 20.0, 0.05) < 1e-9);
/// assert!((p_beyond(0.04, 0.01, 20.0, 0.05) - 1.0).abs() < 1e-12);
/// ```
pub fn p_beyond(estimate: f64, error: f64, freedom: f64, margin: f64) -> f64 {
    let excess = estimate.abs() - margin;
    if excess <= 0.0 || excess.is_nan() {
        return 1.0;
    }
    let tail = StudentsT::new(0.0, 1.0, freedom.max(1.0)).map_or(0.5, |t| t.sf(excess / error));
    (2.0 * tail).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beyond_a_margin() {
        // t = 2.228 with 10 degrees of freedom: 5 % on both sides.
        assert!((p_beyond(-3.228, 1.0, 10.0, 1.0) - 0.05).abs() < 1e-4);
        assert!(p_beyond(2.0, 0.0, 10.0, 1.0) < 1e-12);
        assert!((p_beyond(f64::NAN, 1.0, 10.0, 1.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn each_place() {
        assert_eq!(equivalence((0.9, 1.1), 1.0, 0.2), Place::Within);
        assert_eq!(equivalence((1.3, 1.4), 1.0, 0.2), Place::Outside);
        assert_eq!(equivalence((0.5, 0.6), 1.0, 0.2), Place::Outside);
        assert_eq!(equivalence((0.9, 1.4), 1.0, 0.2), Place::Across);
        assert_eq!(equivalence((f64::NAN, f64::NAN), 1.0, 0.2), Place::Across);
    }
}
