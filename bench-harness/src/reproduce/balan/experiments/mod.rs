//! The experiments: each takes the definition and adds rows to the records.
//!
//! | module | does |
//! |---|---|
//! | [`counts`] | questions asked and facets made by each method |
//! | [`merges`] | comparisons of candidates in each merge of divide and conquer |
//! | [`orders`] | the same for a bad order of insertion and for random ones |
//! | [`angles`] | which point a merge would go to by the paper's angles |
//! | [`times`] | times, interleaved, of certified results only |

pub(crate) mod angles;
pub(crate) mod counts;
pub(crate) mod merges;
pub(crate) mod orders;
pub(crate) mod times;
