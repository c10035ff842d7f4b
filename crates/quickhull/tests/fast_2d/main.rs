//! The fast planar hull against the monotone chain of the checker's oracle, on many small hostile sets; its counts; and
//! what it makes of coordinates that are not finite.

mod counts;
mod differential;
mod not_finite;
mod parallel;
