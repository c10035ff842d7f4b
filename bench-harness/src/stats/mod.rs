//! The statistics that tables and verdicts stand on: plain functions of plain slices.
//!
//! | module | answers |
//! |---|---|
//! | [`summary`] | mean, spread, median, quantiles |
//! | [`wilson`] | between which proportions does k of n leave the truth |
//! | [`bootstrap`] | how far would a median move with other realisations |
//! | [`kendall`] | how alike are two orders |
//! | [`mod@line`] | slope of a weighted line, and its interval |
//! | `logistic` | where does a share of successes fall to a half |
//! | [`interval`] | what an interval says about a target or a bound |
//! | [`holm`] | which of many small p-values are still small together |
//! | [`freedom`] | how many degrees of freedom clusters leave |
//! | [`wilcoxon`] | whether differences have their middle at zero |
//! | [`spearman`] | whether one thing rises with another |
//! | [`runs_test`] | whether signs come in too few runs |
//! | [`growth`] | by which law a cost grows, if the data can tell |

pub mod bootstrap;
pub mod freedom;
pub mod growth;
pub mod holm;
pub mod interval;
pub mod kendall;
pub mod line;
pub(crate) mod logistic;
mod ranks;
pub mod runs_test;
pub mod spearman;
pub mod summary;
pub mod wilcoxon;
pub mod wilson;
