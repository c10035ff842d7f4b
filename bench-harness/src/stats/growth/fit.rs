//! One law fitted to data.
//!
//! The model is cost = (a f + c g) e^noise with noise of one spread: relative error. The sum of squares of the
//! logarithms of measured over modelled cost is made least by Gauss and Newton's steps; each is a weighted linear
//! least squares with weights 1 / (modelled cost)². The response is the same for every law, so their AICc compare.
//!
//! Invariants:
//!
//! 1. The modelled cost is above zero at every observation.
//! 2. No step makes the sum of squares larger.

use super::Observation;
use super::law::{Law, Lower};

/// Scatter below this is taken for this much: differences of a hundredth of a percent tell no laws apart.
const FLOOR: f64 = 1e-4;

/// A law with its factors.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// The law.
    pub law: Law,
    /// The term beside it.
    pub lower: Lower,
    /// The factor of the law, above zero.
    pub leading: f64,
    /// The factor of the term beside it; 0 of none.
    pub correction: f64,
    /// The root of the mean of the squares of ln (measured / modelled).
    pub scatter: f64,
    /// Akaike's criterion for small samples: of two laws, the one with less is preferred.
    pub aicc: f64,
    /// The covariance of the two factors: of the first, between them, of the second.
    covariance: [f64; 3],
}

impl Fit {
    /// The cost it gives at `place`; `None` where the law has no value.
    pub fn at(&self, place: &Observation) -> Option<f64> {
        Some(self.leading * self.law.at(place)? + self.correction * self.lower.at(place))
    }

    /// ln (measured / modelled) at `place`.
    pub fn residual(&self, place: &Observation) -> f64 {
        let modelled = self.at(place).filter(|modelled| *modelled > 0.0);
        modelled.map_or(f64::INFINITY, |modelled| (place.cost / modelled).ln())
    }

    /// Which part of the modelled cost at `place` is the law's own term, and the standard error of this share.
    pub fn share(&self, place: &Observation) -> Option<(f64, f64)> {
        let (f, g) = (self.law.at(place)?, self.lower.at(place));
        let (own, other) = (self.leading * f, self.correction * g);
        let total = own + other;
        let [aa, ac, cc] = self.covariance;
        let (by_own, by_other) = (other / (total * total) * f, -own / (total * total) * g);
        let variance =
            by_own * by_own * aa + 2.0 * by_own * by_other * ac + by_other * by_other * cc;
        Some((own / total, variance.max(0.0).sqrt()))
    }

    /// The standard error of the factor of the law.
    pub fn leading_error(&self) -> f64 {
        self.covariance[0].max(0.0).sqrt()
    }
}

/// `law` fitted to `data`, with the term beside it that AICc prefers; `None` if the law has no value at some
/// observation, or no factor above zero fits.
///
/// Time O(data).
pub fn fit(law: Law, data: &[Observation]) -> Option<Fit> {
    let terms = law.lower_terms().iter();
    let fits = terms.filter_map(|&lower| fit_with(law, lower, data));
    fits.min_by(|a, b| a.aicc.total_cmp(&b.aicc))
}

/// `law` with `lower` beside it fitted to `data`; `None` as for [`fit()`], and if the two terms cannot be told apart.
pub fn fit_with(law: Law, lower: Lower, data: &[Observation]) -> Option<Fit> {
    let rows: Vec<Terms> = data
        .iter()
        .map(|place| {
            Some(Terms {
                f: law.at(place)?,
                g: lower.at(place),
                cost: (place.cost > 0.0).then_some(place.cost)?,
            })
        })
        .collect::<Option<_>>()?;
    let parameters = if lower == Lower::Absent { 1 } else { 2 };
    if rows.len() < parameters + 3 {
        return None;
    }
    // In units of their values at the last observation the factors are of one size.
    let (f_unit, g_unit) = rows.last().map(|row| (row.f, row.g.max(1.0)))?;
    let scaled: Vec<Terms> = rows
        .iter()
        .map(|row| Terms {
            f: row.f / f_unit,
            g: row.g / g_unit,
            cost: row.cost,
        })
        .collect();
    let factors = descend(&scaled, parameters)?;
    if factors[0] <= 0.0 {
        return None;
    }
    let squares = sum_of_squares(&scaled, factors)?;
    let count = rows.len() as f64;
    let variance = squares / (count - parameters as f64);
    let [ff, fg, gg] = normal_matrix(&scaled, factors);
    let covariance = invert(parameters, [ff, fg, gg])?.map(|entry| entry * variance);
    Some(Fit {
        law,
        lower,
        leading: factors[0] / f_unit,
        correction: factors[1] / g_unit,
        scatter: (squares / count).sqrt(),
        aicc: aicc(squares, count, parameters as f64 + 1.0),
        covariance: [
            covariance[0] / (f_unit * f_unit),
            covariance[1] / (f_unit * g_unit),
            covariance[2] / (g_unit * g_unit),
        ],
    })
}

/// Both terms and the cost at one observation.
struct Terms {
    f: f64,
    g: f64,
    cost: f64,
}

impl Terms {
    fn modelled(&self, [a, c]: [f64; 2]) -> f64 {
        a * self.f + c * self.g
    }
}

fn aicc(squares: f64, count: f64, estimated: f64) -> f64 {
    let small = 2.0 * estimated * (estimated + 1.0) / (count - estimated - 1.0);
    count * (squares / count + FLOOR * FLOOR).ln() + 2.0 * estimated + small
}

/// Gauss and Newton's steps from the law alone, halved until they do not make it worse (2).
fn descend(rows: &[Terms], parameters: usize) -> Option<[f64; 2]> {
    const STEPS: usize = 60;
    const HALVINGS: usize = 30;
    let logs = rows.iter().map(|row| (row.cost / row.f).ln());
    let alone = (logs.sum::<f64>() / rows.len() as f64).exp();
    let mut factors = [alone, 0.0];
    let mut squares = sum_of_squares(rows, factors)?;
    if parameters == 1 {
        return Some(factors);
    }
    for _ in 0..STEPS {
        let step = step(rows, factors)?;
        let mut size = 1.0;
        let better = (0..HALVINGS).find_map(|_| {
            let next = [factors[0] + size * step[0], factors[1] + size * step[1]];
            size /= 2.0;
            let found = sum_of_squares(rows, next)?;
            (found <= squares).then_some((next, found))
        });
        let Some((next, found)) = better else { break };
        let gained = squares - found;
        (factors, squares) = (next, found);
        if gained <= 1e-12 * squares {
            break;
        }
    }
    Some(factors)
}

/// The sum of the squares of ln (measured / modelled); `None` where a modelled cost is not above zero (1).
fn sum_of_squares(rows: &[Terms], factors: [f64; 2]) -> Option<f64> {
    rows.iter().try_fold(0.0, |sum, row| {
        let modelled = row.modelled(factors);
        (modelled > 0.0).then(|| sum + (row.cost / modelled).ln().powi(2))
    })
}

/// The step that would be right if the model were linear in the factors.
fn step(rows: &[Terms], factors: [f64; 2]) -> Option<[f64; 2]> {
    let [ff, fg, gg] = invert(2, normal_matrix(rows, factors))?;
    let (mut by_f, mut by_g) = (0.0, 0.0);
    for row in rows {
        let modelled = row.modelled(factors);
        let residual = (row.cost / modelled).ln();
        by_f += residual * row.f / modelled;
        by_g += residual * row.g / modelled;
    }
    Some([ff * by_f + fg * by_g, fg * by_f + gg * by_g])
}

/// The sums of products of the terms over the squared model: f f, f g, g g.
fn normal_matrix(rows: &[Terms], factors: [f64; 2]) -> [f64; 3] {
    rows.iter().fold([0.0; 3], |[ff, fg, gg], row| {
        let modelled = row.modelled(factors);
        let (f, g) = (row.f / modelled, row.g / modelled);
        [ff + f * f, fg + f * g, gg + g * g]
    })
}

/// The inverse of a symmetric matrix of order 1 or 2; `None` if it has none that can be trusted.
fn invert(order: usize, [aa, ab, bb]: [f64; 3]) -> Option<[f64; 3]> {
    if order == 1 {
        return Some([1.0 / aa, 0.0, 0.0]);
    }
    let determinant = aa * bb - ab * ab;
    (determinant > 1e-10 * aa * bb).then(|| [bb / determinant, -ab / determinant, aa / determinant])
}
