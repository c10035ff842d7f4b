//! Which laws of growth a cost may follow: a few models, compared by fit and by foresight.
//!
//! A model is y = a f(n) + b n with a > 0, fitted by least squares of the relative error. It is ruled out if, against the
//! best one, both speak against it: the corrected Akaike criterion by more than ten, and the error at the sizes held out
//! (the upper 30 %) when it is fitted to the others.
//!
//! K. P. Burnham, D. R. Anderson, *Model Selection and Multimodel Inference* (2002).

use std::collections::BTreeSet;

/// A law, from the slowest to the fastest growth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Law {
    Linear,
    Linearithmic,
    LogSquared,
    ThreeHalves,
    Quadratic,
}

impl Law {
    pub(crate) const ALL: [Law; 5] = [
        Law::Linear,
        Law::Linearithmic,
        Law::LogSquared,
        Law::ThreeHalves,
        Law::Quadratic,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Law::Linear => "n",
            Law::Linearithmic => "n log n",
            Law::LogSquared => "n log² n",
            Law::ThreeHalves => "n^1.5",
            Law::Quadratic => "n²",
        }
    }

    /// f(n) / n.
    fn a_point(self, n: f64) -> f64 {
        match self {
            Law::Linear => 1.0,
            Law::Linearithmic => n.ln(),
            Law::LogSquared => n.ln().powi(2),
            Law::ThreeHalves => n.sqrt(),
            Law::Quadratic => n,
        }
    }
}

/// A law fitted to data.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Model {
    pub(crate) law: Law,
    /// The factor of f(n).
    pub(crate) factor: f64,
    /// The factor of n beside it; 0 for the linear law.
    pub(crate) linear: f64,
    /// The root of the mean squared relative error at all sizes.
    pub(crate) error: f64,
    /// The same at the sizes held out, when fitted to the others.
    pub(crate) ahead: f64,
    /// The corrected Akaike criterion less that of the best model.
    pub(crate) behind: f64,
    pub(crate) ruled_out: bool,
}

/// How far behind in the criterion a model is given up.
const FAR_BEHIND: f64 = 10.0;

/// How much worse its foresight must be, too.
const MUCH_WORSE: f64 = 1.5;

/// No data are better than this: below, errors are those of rounding to whole questions.
const FINEST: f64 = 1e-6;

/// Every law fitted to `(n, y)`, in the order of [`Law::ALL`]; none for fewer than six sizes.
pub(crate) fn compare(data: &[(f64, f64)]) -> Vec<Model> {
    let sizes: BTreeSet<u64> = data.iter().map(|(n, _)| *n as u64).collect();
    let sizes: Vec<u64> = sizes.into_iter().collect();
    if sizes.len() < 6 {
        return Vec::new();
    }
    let first_held_out = sizes[(sizes.len() * 7).div_ceil(10)] as f64;
    let (near, far): (Vec<_>, Vec<_>) = data.iter().partition(|(n, _)| *n < first_held_out);
    let mut models: Vec<Model> = Law::ALL
        .into_iter()
        .filter_map(|law| {
            let (factor, linear) = fit(law, data)?;
            let ahead = fit(law, &near);
            Some(Model {
                law,
                factor,
                linear,
                error: error(law, (factor, linear), data),
                ahead: ahead.map_or(f64::INFINITY, |fitted| error(law, fitted, &far)),
                behind: 0.0,
                ruled_out: false,
            })
        })
        .collect();
    let count = data.len() as f64;
    let criterion = |model: &Model| {
        let parameters = if model.law == Law::Linear { 2.0 } else { 3.0 };
        2.0 * count * model.error.max(FINEST).ln()
            + 2.0 * parameters * count / (count - parameters - 1.0)
    };
    let least = |value: &dyn Fn(&Model) -> f64| {
        let grows = models.iter().filter(|model| model.factor > 0.0);
        grows.map(value).fold(f64::INFINITY, f64::min)
    };
    let (best, foresight) = (least(&criterion), least(&|model| model.ahead).max(FINEST));
    for model in &mut models {
        model.behind = criterion(model) - best;
        model.ruled_out = model.factor <= 0.0
            || (model.behind > FAR_BEHIND && model.ahead > MUCH_WORSE * foresight);
    }
    models
}

/// The factors of f(n) and of n that make the squared relative error least.
fn fit(law: Law, data: &[(f64, f64)]) -> Option<(f64, f64)> {
    // y = a f + b n, divided by y: 1 = a u + b v.
    let (mut uu, mut uv, mut vv, mut u1, mut v1) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for &(n, y) in data {
        let (u, v) = (n * law.a_point(n) / y, n / y);
        uu += u * u;
        uv += u * v;
        vv += v * v;
        u1 += u;
        v1 += v;
    }
    if law == Law::Linear {
        return (uu > 0.0).then(|| (u1 / uu, 0.0));
    }
    let determinant = uu * vv - uv * uv;
    (determinant > 1e-12 * uu * vv).then(|| {
        (
            (u1 * vv - v1 * uv) / determinant,
            (v1 * uu - u1 * uv) / determinant,
        )
    })
}

fn error(law: Law, (factor, linear): (f64, f64), data: &[(f64, f64)]) -> f64 {
    let squares = data.iter().map(|&(n, y)| {
        let fitted = n * (factor * law.a_point(n) + linear);
        (fitted / y - 1.0).powi(2)
    });
    (squares.sum::<f64>() / data.len() as f64).sqrt()
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
        assert_eq!(models.len(), Law::ALL.len());
        let kept = models.iter().filter(|model| !model.ruled_out);
        kept.map(|model| model.law).collect()
    }

    #[test]
    fn each_law_is_told_from_the_others() {
        type Cost = fn(f64) -> f64;
        let laws: [(Law, Cost); 5] = [
            (Law::Linear, |n| 5.0 * n),
            (Law::Linearithmic, |n| n * (4.0 * n.ln() - 3.0)),
            (Law::LogSquared, |n| n * (n.ln().powi(2) + 2.0)),
            (Law::ThreeHalves, |n| n * (3.0 * n.sqrt() + 7.0)),
            (Law::Quadratic, |n| n * (0.125 * n + 2.0)),
        ];
        for (law, cost) in laws {
            let left = left(cost, 1e-4);
            assert!(left.contains(&law), "{law:?} {left:?}");
            // Anything linear follows every other law with that law's factor at 0, but for its sign.
            if law != Law::Linear {
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
