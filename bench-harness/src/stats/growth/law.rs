//! The candidate laws.

use super::Observation;
use std::fmt;

/// How a cost may grow with the number of points n and of vertices h.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Law {
    /// n
    N,
    /// n log h
    NLogH,
    /// n log n
    NLogN,
    /// n log² n
    NLog2N,
    /// n^(4/3)
    N4Over3,
    /// n^1.5
    N3Over2,
    /// n h
    NH,
    /// n^(5/3)
    N5Over3,
    /// n²
    N2,
    /// n² log n
    N2LogN,
}

/// A term of lower order beside a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lower {
    /// None.
    Absent,
    /// + c
    Constant,
    /// + c n
    Linear,
}

impl Law {
    /// Every law, those in n by growth.
    pub const ALL: [Law; 10] = [
        Law::N,
        Law::NLogH,
        Law::NLogN,
        Law::NLog2N,
        Law::N4Over3,
        Law::N3Over2,
        Law::NH,
        Law::N5Over3,
        Law::N2,
        Law::N2LogN,
    ];

    /// Its value, without a factor; `None` if it needs an h that is not known, or is not above zero there.
    pub fn at(self, place: &Observation) -> Option<f64> {
        let n = place.n;
        let log = n.ln();
        let value = match self {
            Law::N => n,
            Law::NLogH => n * place.h?.ln(),
            Law::NLogN => n * log,
            Law::NLog2N => n * log * log,
            Law::N4Over3 => n.powf(4.0 / 3.0),
            Law::N3Over2 => n.powf(1.5),
            Law::NH => n * place.h?,
            Law::N5Over3 => n.powf(5.0 / 3.0),
            Law::N2 => n * n,
            Law::N2LogN => n * n * log,
        };
        (value > 0.0 && value.is_finite()).then_some(value)
    }

    /// Whether it speaks of h.
    pub fn is_in_h(self) -> bool {
        matches!(self, Law::NLogH | Law::NH)
    }

    /// The terms that are of lower order than it.
    pub fn lower_terms(self) -> &'static [Lower] {
        match self {
            Law::N => &[Lower::Absent, Lower::Constant],
            _ => &[Lower::Absent, Lower::Constant, Lower::Linear],
        }
    }
}

impl Lower {
    /// Its value, without a factor.
    pub fn at(self, place: &Observation) -> f64 {
        match self {
            Lower::Absent => 0.0,
            Lower::Constant => 1.0,
            Lower::Linear => place.n,
        }
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Law::N => "n",
            Law::NLogH => "n log h",
            Law::NLogN => "n log n",
            Law::NLog2N => "n log² n",
            Law::N4Over3 => "n^(4/3)",
            Law::N3Over2 => "n^1.5",
            Law::NH => "n h",
            Law::N5Over3 => "n^(5/3)",
            Law::N2 => "n²",
            Law::N2LogN => "n² log n",
        })
    }
}

impl fmt::Display for Lower {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Lower::Absent => "",
            Lower::Constant => " + c",
            Lower::Linear => " + c n",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_in_n_are_in_the_order_of_their_growth() {
        let far = |law: Law| {
            law.at(&Observation {
                n: 1e30,
                h: None,
                cost: 1.0,
            })
        };
        let values: Vec<f64> = Law::ALL.into_iter().filter_map(far).collect();
        assert_eq!(values.len(), 8);
        assert!(values.is_sorted());
    }

    #[test]
    fn a_law_without_a_value_says_so() {
        let one = Observation {
            n: 1.0,
            h: Some(1.0),
            cost: 1.0,
        };
        assert!(Law::NLogN.at(&one).is_none() && Law::NLogH.at(&one).is_none());
        assert_eq!(Law::NH.at(&one), Some(1.0));
    }
}
