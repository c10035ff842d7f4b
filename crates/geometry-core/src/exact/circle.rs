//! In-circle.
use super::scaled;
use crate::kernel::Stage;
use crate::points::Point2;
use crate::sign::Sign;

pub(super) fn in_circle(a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
    (scaled::in_circle(a, b, c, d), Stage::Integer)
}
