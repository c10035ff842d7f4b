//! The studies: each takes what it runs on and adds rows to the records.
//!
//! | module | does | for |
//! |---|---|---|
//! | [`wraps`] | wraps as printed, corrected, and by pivoting, everything counted | N-1, N-2, N-3 |
//! | [`starts`] | first points that are on the hull or not | N-4 |
//! | [`epsilon`] | the paper's arithmetic against exact answers | N-5 |
//! | [`corners`], [`own_corners`] | the own corners tested or skipped, on the clock | N-6 |
//! | [`lifting`] | triangulations by rounded and by exact lifts | N-7 |
//! | [`sweep`] | a moving box and its obstacles | N-8 |

pub(crate) mod corners;
pub(crate) mod epsilon;
pub(crate) mod lifting;
pub(crate) mod own_corners;
pub(crate) mod starts;
pub(crate) mod sweep;
pub(crate) mod wraps;

use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use geometry_core::Hull3;

/// The certified hull of `set`, by the fast method; the failure if there is none.
fn proved(stage: &str, set: &PointSet3) -> Result<Result<Hull3, Vec<FailureRow>>> {
    let certified = certify(stage, set, &["quickhull-3d".to_owned()])?;
    Ok(certified.hull.ok_or(certified.failures))
}

/// A failure of `method` on `set`.
fn failure(stage: &str, set: &PointSet3, method: &str, what: &str) -> FailureRow {
    FailureRow {
        stage: stage.to_owned(),
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        method: method.to_owned(),
        what: what.to_owned(),
    }
}
