//! The report on Balan, Munjal and Rao. Nothing here runs an algorithm or a clock.

pub(crate) mod angles;
pub(crate) mod figures;
pub(crate) mod tables;
