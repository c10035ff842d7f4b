//! Definite integrals of smooth functions with one sharp peak.
//!
//! Gauss–Kronrod with 7 and 15 nodes; an interval whose two estimates disagree is halved. The intervals to
//! be halved stand on a stack of bounded depth, so there is no recursion.

/// Halvings after which an interval is accepted as it is: by then it is 2⁻⁶⁰ of the whole.
const DEEPEST: u32 = 60;

/// ∫ `f` from `from` to `to`, to a relative accuracy of about 1e-12 of the largest partial integral.
///
/// `f` is evaluated at interior points only, so it may be singular at the ends.
pub(crate) fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    graded(&f, &[from, to])
}

/// [`integral`] with the interval first cut at `from` + (`to` - `from`) 2⁻ᵏ, k = 1, 2, …, so that a peak
/// next to `from` is found however narrow it is.
pub(crate) fn integral_peaked_at_start(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let mut cuts: Vec<f64> = (0..DEEPEST)
        .map(|k| from + (to - from) * 0.5_f64.powi(k as i32))
        .collect();
    cuts.push(from);
    cuts.reverse();
    graded(&f, &cuts)
}

fn graded(f: &impl Fn(f64) -> f64, cuts: &[f64]) -> f64 {
    let rough: f64 = cuts
        .windows(2)
        .map(|cut| gauss_kronrod(f, cut[0], cut[1]).0.abs())
        .sum();
    let accuracy = 1e-13 * rough.max(f64::MIN_POSITIVE);
    let mut open: Vec<(f64, f64, u32)> = cuts.windows(2).map(|cut| (cut[0], cut[1], 0)).collect();
    let mut sum = 0.0;
    while let Some((a, b, depth)) = open.pop() {
        let (value, error) = gauss_kronrod(f, a, b);
        if error <= accuracy || depth == DEEPEST {
            sum += value;
        } else {
            let middle = a + (b - a) / 2.0;
            open.push((a, middle, depth + 1));
            open.push((middle, b, depth + 1));
        }
    }
    sum
}

/// The 15-node estimate of ∫ f from a to b, and its distance from the 7-node one.
fn gauss_kronrod(f: &impl Fn(f64) -> f64, a: f64, b: f64) -> (f64, f64) {
    let (center, half) = (a + (b - a) / 2.0, (b - a) / 2.0);
    let middle = f(center);
    let mut kronrod = KRONROD_WEIGHTS[7] * middle;
    let mut gauss = GAUSS_WEIGHTS[3] * middle;
    for (k, &node) in NODES.iter().enumerate() {
        let pair = f(center - half * node) + f(center + half * node);
        kronrod += KRONROD_WEIGHTS[k] * pair;
        if k % 2 == 1 {
            gauss += GAUSS_WEIGHTS[k / 2] * pair;
        }
    }
    (kronrod * half, ((kronrod - gauss) * half).abs())
}

/// Positive nodes of the 15-point Kronrod rule on [-1, 1]; those at odd places are the Gauss nodes.
const NODES: [f64; 7] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
];

const KRONROD_WEIGHTS: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];

const GAUSS_WEIGHTS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_exact() {
        for degree in 0..14 {
            let (value, error) = gauss_kronrod(&|x: f64| x.powi(degree), 0.0, 1.0);
            assert!(
                (value - 1.0 / f64::from(degree + 1)).abs() < 1e-15,
                "degree {degree}"
            );
            assert!(error < 1e-15, "degree {degree}: {error}");
        }
    }

    #[test]
    fn known_integrals() {
        let gaussian = integral(|x| (-x * x).exp(), -40.0, 40.0);
        assert!((gaussian - std::f64::consts::PI.sqrt()).abs() < 1e-12);
        let singular = integral(|x: f64| -x.ln(), 0.0, 1.0);
        assert!((singular - 1.0).abs() < 1e-11);
    }

    #[test]
    fn a_narrow_peak_at_the_start_is_found() {
        let value = integral_peaked_at_start(|x| 1e9 * (-1e9 * x).exp(), 0.0, 1.0);
        assert!((value - 1.0).abs() < 1e-12);
    }
}
