//! The sections of a report, a file each. A section of which the run says nothing is not there.

pub(super) mod failures;
pub(super) mod growth;
pub(super) mod machine;
pub(super) mod memory;
pub(super) mod overview;
pub(super) mod published;
pub(super) mod ranking;
pub(super) mod ratios;
pub(super) mod side_by_side;
pub(super) mod targets;
pub(super) mod verdicts;
