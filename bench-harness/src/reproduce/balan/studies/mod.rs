//! The studies: each takes what it runs on and adds rows to the records.
//!
//! | module | does |
//! |---|---|
//! | [`merges`] | comparisons of candidates in each merge of divide and conquer |
//! | [`orders`] | facets made in a bad order of insertion and in random ones |
//! | [`angles`] | which point a merge would go to by the paper's angles |

pub(crate) mod angles;
pub(crate) mod merges;
pub(crate) mod orders;
