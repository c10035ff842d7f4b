//! The choice of a law, on made-up data whose law is known.

use super::fit::fit_with;
use super::{Law, Lower, Observation, Reason, Verdict, choose, fit};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The sum of twelve uniform draws, less its mean: variance 1, nearly normal.
fn noise(random: &mut ChaCha8Rng) -> f64 {
    (0..12).map(|_| random.random::<f64>() - 0.5).sum()
}

/// What a made-up experiment does.
#[derive(Clone, Copy)]
struct Plan {
    law: Law,
    lower: (Lower, f64),
    /// Sizes 2^from to 2^to.
    doublings: (i32, i32),
    seeds: usize,
    /// Relative scatter between realisations.
    spread: f64,
}

impl Plan {
    fn of(law: Law) -> Self {
        Self {
            law,
            lower: (Lower::Absent, 0.0),
            doublings: (8, 20),
            seeds: 6,
            spread: 0.02,
        }
    }

    /// Costs of sets whose h is about 3 n^(1/3).
    fn data(&self, seed: u64) -> Vec<Observation> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut data = Vec::new();
        for power in self.doublings.0..=self.doublings.1 {
            let n = 2_f64.powi(power);
            for _ in 0..self.seeds {
                let h = (3.0 * n.cbrt() * (0.05 * noise(&mut random)).exp()).round();
                let mut place = Observation {
                    n,
                    h: Some(h),
                    cost: 1.0,
                };
                let own = 3.0 * self.law.at(&place).expect("a value");
                let other = self.lower.1 * self.lower.0.at(&place);
                place.cost = (own + other) * (self.spread * noise(&mut random)).exp();
                data.push(place);
            }
        }
        data
    }
}

/// How many of `rounds` experiments are judged to follow their law, and which others are declared in its place.
fn tally(plan: Plan, rounds: u64) -> (usize, Vec<String>) {
    let mut right = 0;
    let mut wrong = Vec::new();
    for seed in 0..rounds {
        match choose(&plan.data(seed)).verdict {
            Verdict::Law { law, same_here } if law == plan.law || same_here.contains(&plan.law) => {
                right += 1;
            }
            Verdict::Law { law, .. } => wrong.push(format!("seed {seed}: {law}")),
            Verdict::NotDistinguishable(_) => {}
        }
    }
    (right, wrong)
}

#[test]
fn each_law_is_recovered_with_and_without_a_lower_term() {
    let lower_terms = [
        (Lower::Absent, 0.0),
        (Lower::Linear, 2.0),
        (Lower::Constant, 100.0),
    ];
    for law in Law::ALL {
        for lower in lower_terms {
            let (right, wrong) = tally(
                Plan {
                    lower,
                    ..Plan::of(law)
                },
                20,
            );
            assert!(right >= 14, "{law}{}: {right} of 20", lower.0);
            assert!(wrong.len() <= 1, "{law}{}: {wrong:?}", lower.0);
        }
    }
}

#[test]
fn on_a_short_range_neighbours_are_not_told_apart_and_hardly_ever_wrongly() {
    for law in [Law::N, Law::NLogN, Law::NLog2N, Law::N3Over2] {
        let plan = Plan {
            doublings: (8, 12),
            seeds: 3,
            spread: 0.1,
            ..Plan::of(law)
        };
        let (right, wrong) = tally(plan, 60);
        assert!(right <= 6, "{law}: {right} of 60 declared");
        assert!(wrong.len() <= 2, "{law}: {wrong:?}");
    }
    let few = Plan {
        doublings: (8, 11),
        ..Plan::of(Law::N2)
    };
    assert_eq!(
        choose(&few.data(1)).verdict,
        Verdict::NotDistinguishable(Reason::TooFewSizes)
    );
}

#[test]
fn a_law_that_is_no_candidate_is_not_taken_for_one() {
    // Not 1.2: n log² n + c n lies too near it on these sizes.
    for exponent in [1.6, 1.8] {
        let declared = (0..20).filter(|seed| {
            let mut data = Plan::of(Law::N).data(*seed);
            for place in &mut data {
                place.cost = place.cost.powf(exponent);
            }
            matches!(choose(&data).verdict, Verdict::Law { .. })
        });
        let declared = declared.count();
        assert!(declared <= 1, "n^{exponent}: {declared} of 20 declared");
    }
}

#[test]
fn exact_counts_are_judged_though_what_they_leave_over_has_a_pattern() {
    let data: Vec<Observation> = (6..15)
        .map(|power| 2_f64.powi(power))
        .map(|n| Observation {
            n,
            h: Some(n),
            cost: (n - 1.0) * (n - 4.0),
        })
        .collect();
    let Verdict::Law { law, same_here } = choose(&data).verdict else {
        panic!("{}", choose(&data).verdict);
    };
    // On a sphere h = n: n h is n².
    assert_eq!((law, same_here), (Law::N2, vec![Law::NH]));
}

#[test]
fn the_unit_of_cost_does_not_matter() {
    let data = Plan::of(Law::NLogN).data(5);
    let scaled: Vec<Observation> = data
        .iter()
        .map(|place| Observation {
            cost: place.cost * 1e-9,
            ..*place
        })
        .collect();
    assert_eq!(choose(&data).verdict, choose(&scaled).verdict);
    for law in Law::ALL {
        let [a, b] = [&data, &scaled].map(|data| fit(law, data).expect("a fit"));
        assert!((b.leading / a.leading / 1e-9 - 1.0).abs() < 1e-6, "{law}");
        assert!((a.aicc - b.aicc).abs() < 1e-6, "{law}");
    }
}

#[test]
fn factors_come_back_from_data_without_noise_and_with_it_within_their_error() {
    let plan = Plan {
        lower: (Lower::Linear, -5.0),
        spread: 0.0,
        ..Plan::of(Law::NLogN)
    };
    let exact = fit_with(Law::NLogN, Lower::Linear, &plan.data(1)).expect("a fit");
    assert!((exact.leading - 3.0).abs() < 1e-6 && (exact.correction + 5.0).abs() < 1e-5);
    let noisy = Plan {
        spread: 0.05,
        ..plan
    };
    let within = (0..200).filter(|seed| {
        let fit = fit_with(Law::NLogN, Lower::Linear, &noisy.data(*seed)).expect("a fit");
        (fit.leading - 3.0).abs() < 1.96 * fit.leading_error()
    });
    let within = within.count();
    assert!(
        (180..=199).contains(&within),
        "{within} of 200 within 1.96 errors"
    );
}

#[test]
fn terms_that_are_one_cannot_be_fitted_together() {
    let mut data = Plan::of(Law::NLogH).data(1);
    for place in &mut data {
        place.h = Some(8.0);
    }
    assert!(fit_with(Law::NLogH, Lower::Linear, &data).is_none());
    assert!(
        choose(&data)
            .candidates
            .iter()
            .all(|c| !c.fit.law.is_in_h())
    );
    assert!(fit(Law::N, &[]).is_none() && choose(&[]).candidates.is_empty());
}
