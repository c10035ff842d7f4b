//! The studies: each takes what it runs on and adds rows to the records.
//!
//! | module | does | for |
//! |---|---|---|
//! | [`precision`] | Day's cotangents in several formats, over powers of ten of eps2 | D-1 |
//! | [`speed`] | times of the formats | D-2 |
//! | [`merges`] | what every merge asks and keeps | D-3, D-4, D-5 |
//! | [`bases`] | orientations with the recursion stopped earlier; dummy points | D-6 |
//! | [`turned`] | the whole call on sets that are in no catalogue | D-7 |
//! | [`battery`] | degenerate sets | D-8 |
//! | [`listing`] | faces by the spiral and plainly | D-9 |
//! | [`checks`] | the paper's own check of hulls that are known to be right or wrong | D-10 |
//! | [`side_by_side`] | the halves conquered on all processors | D-11 |

pub(crate) mod bases;
pub(crate) mod battery;
pub(crate) mod checks;
pub(crate) mod listing;
pub(crate) mod merges;
pub(crate) mod precision;
pub(crate) mod side_by_side;
pub(crate) mod speed;
pub(crate) mod turned;

use super::formats::Machine;
use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use geometry_core::Hull3;

/// Day's method as registered, with exact orientations.
pub(crate) const METHOD: &str = "preparata-hong-3d";

/// The same method with the halves conquered side by side.
pub(crate) const PARALLEL: &str = "preparata-hong-parallel";

/// `set` as `machine` holds it, and its certified hull by the exact method; the failure if there is none.
fn proved_in(
    stage: &str,
    set: PointSet3,
    machine: &Machine,
) -> Result<(PointSet3, Result<Hull3, Vec<FailureRow>>)> {
    let name = set.distribution.clone();
    let set = set.changed(&name, |points| *points = (machine.rounded)(points));
    let certified = certify(stage, &set, &[METHOD.to_owned()])?;
    Ok((set, certified.hull.ok_or(certified.failures)))
}
