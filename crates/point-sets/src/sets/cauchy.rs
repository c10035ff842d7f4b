//! Points of the bivariate Cauchy distribution.
//!
//! ```text
//!                               ·
//!          · ·
//!    ·    ·:::·      ·                            ·
//!          ·:·                    a dense middle, and few points very far out
//!      ·
//!                     ·
//! ```
//!
//! The multivariate t distribution with one degree of freedom: a circular normal point divided by the
//! magnitude of an independent standard normal. It looks alike from every direction, which two independent
//! Cauchy coordinates do not. The distance r has P(r > t) = 1/sqrt(1 + t²). As n grows the expected number of
//! extreme points tends to π²/2.

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "cauchy",
    summary: "bivariate Cauchy: circular normal divided by |standard normal|",
    parameters: &[],
    source: "Green and Silverman 1979, Table 2, column Cauchy",
    generate: Generate::Plane(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| point(&mut draw)).collect())
    }),
};

/// Drawn again in the (never yet seen) case of a divisor so small that a quotient overflows.
fn point(draw: &mut Draw) -> [f64; 2] {
    loop {
        let (x, y) = (draw.normal(), draw.normal());
        let divisor = draw.normal().abs();
        let point = [x / divisor, y / divisor];
        if point.iter().all(|coordinate| coordinate.is_finite()) {
            return point;
        }
    }
}
