//! Orientation in space: (b-a) × (c-a) · (d-a).
use super::scaled;
use crate::kernel::Stage;
use crate::points::Point3;
use crate::sign::Sign;

/// TODO
pub(super) fn orient(a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
    (scaled::orient_in_space(a, b, c, d), Stage::Integer)
}
