//! Which laws of growth the data leave (D-3, D-7).
//!
//! The fitter is that of [`crate::stats::growth`]; the rule is the one that D-7 states, and does another job: there one
//! law is declared or none, here laws are ruled out until a claim is decided. Each of five laws is fitted with a
//! term in n beside it. It is ruled out if, against the best one, both speak against it: the corrected Akaike
//! criterion by more than ten, and the error at the sizes held out (the upper 30 %) when it is fitted to the others.
//!
//! K. P. Burnham, D. R. Anderson, *Model Selection and Multimodel Inference* (2002).

use crate::stats::growth::fit::fit_with;
use crate::stats::growth::{Fit, Law, Lower, Observation};
use std::collections::BTreeSet;

/// The laws, from the slowest to the fastest growth.
const LAWS: [Law; 5] = [Law::N, Law::NLogN, Law::NLog2N, Law::N3Over2, Law::N2];

/// A law beside the data.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model {
    pub(crate) law: Law,
    /// Fitted to all of them; none if no factor above zero fits.
    pub(crate) fit: Option<Fit>,
    /// The root of the mean squared relative error at the sizes held out, when fitted to the others.
    pub(crate) ahead: f64,
    /// The corrected Akaike criterion less that of the best model.
    pub(crate) behind: f64,
    pub(crate) ruled_out: bool,
}

/// With fewer sizes nothing is said.
const FEWEST_SIZES: usize = 6;

/// How far behind in the criterion a model is given up.
const FAR_BEHIND: f64 = 10.0;

/// How much worse its foresight must be, too.
const MUCH_WORSE: f64 = 1.5;

/// No foresight is better than this: below, errors are those of rounding to whole questions.
const FINEST: f64 = 1e-6;

/// Every law fitted to `(n, cost)`, in the order of growth; none for fewer than six sizes.
pub(crate) fn compare(data: &[(f64, f64)]) -> Vec<Model> {
    let sizes: BTreeSet<u64> = data.iter().map(|(n, _)| *n as u64).collect();
    let sizes: Vec<u64> = sizes.into_iter().collect();
    if sizes.len() < FEWEST_SIZES {
        return Vec::new();
    }
    let first_held_out = sizes[(sizes.len() * 7).div_ceil(10)] as f64;
    let place = |&(n, cost): &(f64, f64)| Observation { n, h: None, cost };
    let data: Vec<Observation> = data.iter().map(place).collect();
    let (near, far): (Vec<Observation>, Vec<_>) =
        data.iter().partition(|place| place.n < first_held_out);
    let fit = |law, data: &[Observation]| {
        let beside = if law == Law::N {
            Lower::Absent
        } else {
            Lower::Linear
        };
        fit_with(law, beside, data)
    };
    let fits = LAWS.map(|law| (law, fit(law, &data), fit(law, &near)));
    let criteria = fits.iter().filter_map(|(_, whole, _)| Some((*whole)?.aicc));
    let best = criteria.fold(f64::INFINITY, f64::min);
    let ahead = |part: &Option<Fit>| part.map_or(f64::INFINITY, |part| error(&part, &far));
    let foresights = fits.iter().map(|(_, _, part)| ahead(part));
    let foresight = foresights.fold(f64::INFINITY, f64::min).max(FINEST);
    let model = |(law, whole, part): (Law, Option<Fit>, Option<Fit>)| {
        let behind = whole.map_or(f64::INFINITY, |whole| whole.aicc - best);
        let ahead = ahead(&part);
        Model {
            law,
            fit: whole,
            ahead,
            behind,
            ruled_out: whole.is_none() || (behind > FAR_BEHIND && ahead > MUCH_WORSE * foresight),
        }
    };
    fits.map(model).to_vec()
}

/// The root of the mean squared relative error of `fit` at these places.
fn error(fit: &Fit, places: &[Observation]) -> f64 {
    let squares = places
        .iter()
        .map(|place| (-fit.residual(place)).exp_m1().powi(2));
    (squares.sum::<f64>() / places.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn left(cost: impl Fn(f64) -> f64, spread: f64) -> Vec<Law> {
        let data: Vec<(f64, f64)> = (7..17)
            .flat_map(|doubling| {
                let n = f64::from(1 << doubling);
                // Uneven, but the same every time.
                let wobble = f64::from(doubling * 7919 % 13) / 6.0 - 1.0;
                [
                    (n, cost(n) * (1.0 + spread * wobble)),
                    (n, cost(n) * (1.0 - spread)),
                ]
            })
            .collect();
        let models = compare(&data);
        assert_eq!(models.len(), LAWS.len());
        let kept = models.iter().filter(|model| !model.ruled_out);
        kept.map(|model| model.law).collect()
    }

    #[test]
    fn each_law_is_told_from_the_others() {
        type Cost = fn(f64) -> f64;
        let laws: [(Law, Cost); 5] = [
            (Law::N, |n| 5.0 * n),
            (Law::NLogN, |n| n * (4.0 * n.ln() - 3.0)),
            (Law::NLog2N, |n| n * (n.ln().powi(2) + 2.0)),
            (Law::N3Over2, |n| n * (3.0 * n.sqrt() + 7.0)),
            (Law::N2, |n| n * (0.125 * n + 2.0)),
        ];
        for (law, cost) in laws {
            let left = left(cost, 1e-4);
            assert!(left.contains(&law), "{law:?} {left:?}");
            // Anything linear follows every other law with that law's factor at 0, but for its sign.
            if law != Law::N {
                assert_eq!(left, [law]);
            }
        }
    }

    #[test]
    fn scatter_leaves_several_and_few_sizes_none() {
        assert!(left(|n| n * n.ln(), 0.3).len() > 1);
        assert!(compare(&[(1.0, 1.0), (2.0, 2.0)]).is_empty());
    }
}
