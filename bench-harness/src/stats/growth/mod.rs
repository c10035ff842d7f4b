//! By which law a cost grows, if the data can tell.
//!
//! C. C. McGeoch, *A Guide to Experimental Algorithmics*, Cambridge University Press (2012), chapter 5; C. M. Hurvich and
//! C.-L. Tsai, *Regression and time series model selection in small samples*, Biometrika 76 (1989).
//!
//! 1. Each candidate law, alone and with one lower-order term, is fitted by least squares of the relative error
//!    ([`mod@fit`]).
//! 2. A law whose leading term is a mere correction at the largest size is none of its name and drops out: with an
//!    extra term every law contains every lower one.
//! 3. One is declared ([`choice`]) only if AICc prefers it to each other by more than 10, if it also foretells the
//!    upper 30 % of the sizes best when fitted to the lower 70 %, and if what is left over shows no pattern.
//! 4. Otherwise the answer is "not distinguishable on this range", which is a result.
//!
//! The answer is one of the candidates: a cost in n^1.2 may be called n log² n, which is near it on any range
//! that can be measured.
//!
//! A law in h and a law in n may be one law on a set whose h is a power of n; then both are named.
//! [`slopes`] says how steep the data are, and how steep each law would be at the same sizes: n log n has slope 1.1
//! between a thousand and a million.

pub mod choice;
pub mod fit;
pub mod law;
pub mod slopes;

pub use choice::{Choice, Reason, Verdict, choose};
pub use fit::{Fit, fit};
pub use law::{Law, Lower};

/// One measured cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// The number of points.
    pub n: f64,
    /// The number of vertices of their hull, if it is known.
    pub h: Option<f64>,
    /// The cost, above zero.
    pub cost: f64,
}

#[cfg(test)]
mod tests;
