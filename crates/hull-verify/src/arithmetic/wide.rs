//! Products of two 128-bit integers, compared without rounding.

use std::cmp::Ordering;

/// Compares `left[0] · left[1]` with `right[0] · right[1]`.
///
/// ```
/// use hull_verify::arithmetic::wide::compare_products;
/// let x = i128::MAX;
/// assert!(compare_products([x, x], [x, x - 1]).is_gt());
/// assert!(compare_products([x, -x], [-x, x]).is_eq());
/// ```
pub fn compare_products(left: [i128; 2], right: [i128; 2]) -> Ordering {
    let (a, b) = (product(left), product(right));
    a.sign.cmp(&b.sign).then_with(|| match a.sign {
        0 => Ordering::Equal,
        1 => a.magnitude.cmp(&b.magnitude),
        _ => b.magnitude.cmp(&a.magnitude),
    })
}

/// A product: its sign, and its magnitude as (high, low) halves of 128 bits.
struct Product {
    sign: i128,
    magnitude: (u128, u128),
}

fn product([x, y]: [i128; 2]) -> Product {
    Product {
        sign: x.signum() * y.signum(),
        magnitude: multiply(x.unsigned_abs(), y.unsigned_abs()),
    }
}

/// The 256-bit product of x and y, schoolbook in limbs of 64 bits.
fn multiply(x: u128, y: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let ([x0, x1], [y0, y1]) = ([x & LOW, x >> 64], [y & LOW, y >> 64]);
    let (low, mid, cross, high) = (x0 * y0, x0 * y1, x1 * y0, x1 * y1);
    // Three terms below 2⁶⁴ each: no overflow.
    let middle = (low >> 64) + (mid & LOW) + (cross & LOW);
    (
        high + (mid >> 64) + (cross >> 64) + (middle >> 64),
        (middle << 64) | (low & LOW),
    )
}
