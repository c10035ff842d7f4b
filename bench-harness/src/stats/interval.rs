//! What an interval says about a target.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place() {
        assert_eq!(equivalence((0.9, 1.1), 1.0, 0.2), Place::Within);
        assert_eq!(equivalence((1.3, 1.4), 1.0, 0.2), Place::Outside);
        assert_eq!(equivalence((0.5, 0.6), 1.0, 0.2), Place::Outside);
        assert_eq!(equivalence((0.9, 1.4), 1.0, 0.2), Place::Across);
        assert_eq!(equivalence((f64::NAN, f64::NAN), 1.0, 0.2), Place::Across);
    }
}
