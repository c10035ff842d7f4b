//! Whether signs come in too few runs to be in random order.
//!
//! A. Wald and J. Wolfowitz, *On a test whether two samples are from the same population*, Annals of Mathematical
//! Statistics 11 (1940). The exact distribution: with p plus signs and m minus signs, 2k runs arise in
//! 2 C(p-1, k-1) C(m-1, k-1) of the C(p+m, p) orders, 2k+1 runs in C(p-1, k) C(m-1, k-1) + C(p-1, k-1) C(m-1, k).

/// The probability of as few runs of equal sign as `values` have, or fewer, if their order were random; zeros are
/// left out. 1 if all have the same sign.
///
/// ```
/// use bench_harness::stats::runs_test::too_few_runs;
/// // Five of each sign, in two runs: 2 of 252 orders.
/// let bent = [-1.0, -2.0, -1.0, -3.0, -1.0, 1.0, 2.0, 1.0, 1.0, 2.0];
/// assert!((too_few_runs(&bent) - 2.0 / 252.0).abs() < 1e-12);
/// ```
pub fn too_few_runs(values: &[f64]) -> f64 {
    let signs: Vec<bool> = values
        .iter()
        .filter(|value| **value != 0.0)
        .map(|value| *value > 0.0)
        .collect();
    let plus = signs.iter().filter(|sign| **sign).count();
    let minus = signs.len() - plus;
    if plus == 0 || minus == 0 {
        return 1.0;
    }
    let runs = 1 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    let (p, m) = (plus - 1, minus - 1);
    let orders = |runs: usize| {
        let k = runs / 2;
        if runs.is_multiple_of(2) {
            2.0 * choose(p, k - 1) * choose(m, k - 1)
        } else {
            choose(p, k) * choose(m, k - 1) + choose(p, k - 1) * choose(m, k)
        }
    };
    let few: f64 = (2..=runs).map(orders).sum();
    (few / choose(plus + minus, plus)).min(1.0)
}

/// The number of ways to choose `k` of `n`.
fn choose(n: usize, k: usize) -> f64 {
    if k > n {
        return 0.0;
    }
    (0..k).map(|i| (n - i) as f64 / (i + 1) as f64).product()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every order of `plus` plus and `minus` minus signs.
    fn orders(plus: usize, minus: usize) -> Vec<Vec<f64>> {
        let length = plus + minus;
        let masks = (0_u32..1 << length).filter(|mask| mask.count_ones() as usize == plus);
        let signs = |mask: u32| {
            let sign = |bit: usize| if mask >> bit & 1 == 1 { 1.0 } else { -1.0 };
            (0..length).map(sign).collect()
        };
        masks.map(signs).collect()
    }

    #[test]
    fn agrees_with_counting_every_order() {
        let runs = |signs: &[f64]| 1 + signs.windows(2).filter(|w| w[0] * w[1] < 0.0).count();
        for (plus, minus) in [(1, 1), (2, 3), (4, 4), (3, 6)] {
            let all = orders(plus, minus);
            for signs in &all {
                let few = all
                    .iter()
                    .filter(|other| runs(other) <= runs(signs))
                    .count();
                let by_hand = few as f64 / all.len() as f64;
                assert!((too_few_runs(signs) - by_hand).abs() < 1e-12, "{signs:?}");
            }
        }
    }

    #[test]
    fn one_sign_says_nothing() {
        assert!((too_few_runs(&[1.0, 2.0, 0.0]) - 1.0).abs() < 1e-15);
        assert!((too_few_runs(&[]) - 1.0).abs() < 1e-15);
    }
}
