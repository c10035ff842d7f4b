//! Points of the trivariate Cauchy distribution.
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
//! The multivariate t distribution with one degree of freedom: a spherical normal point divided by the
//! magnitude of an independent standard normal. It looks alike from every direction, which three independent
//! Cauchy coordinates do not. As n grows the expected number of extreme points tends to 2 + 2π²/3.

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "cauchy3",
    summary: "trivariate Cauchy: spherical normal divided by |standard normal|",
    parameters: &[],
    source: "the Cauchy column of Green and Silverman 1979, Table 2, one dimension up",
    generate: Generate::Space(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| point(&mut draw)).collect())
    }),
};

/// Drawn again in the (never yet seen) case of a divisor so small that a quotient overflows.
fn point(draw: &mut Draw) -> [f64; 3] {
    loop {
        let normal = [(); 3].map(|()| draw.normal());
        let divisor = draw.normal().abs();
        let point = normal.map(|coordinate| coordinate / divisor);
        if point.iter().all(|coordinate| coordinate.is_finite()) {
            return point;
        }
    }
}
