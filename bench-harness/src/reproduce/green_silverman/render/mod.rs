//! The report on Green and Silverman.
//!
//! Nothing here runs an algorithm on a clock; the pictures of Figures 1 and 2 are peeled anew.

pub(crate) mod growth;
pub(crate) mod peeling;
pub(crate) mod peels;
pub(crate) mod table1;
pub(crate) mod table2;
