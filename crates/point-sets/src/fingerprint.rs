//! Which points a record is about, to the last bit.

use sha2::{Digest, Sha256};
use std::fmt;

/// SHA-256 of the dimension, the number of points and the coordinates' bits.
///
/// [`Display`](fmt::Display) prints the first 16 hexadecimal digits, enough to tell sets apart in a table;
/// [`Fingerprint::full`] all 64.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Fingerprint([u8; 32]);

impl Fingerprint {
    /// All 64 hexadecimal digits.
    pub fn full(&self) -> String {
        self.0.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The 32 bytes.
    pub fn as_bytes(&self) -> &[u8; 32] {
        &self.0
    }
}

/// The fingerprint of `points`, in their order.
///
/// Hashed are D and n as 64-bit integers and then every coordinate's bits, all little-endian. So 0 and -0
/// differ, as does any other order of the points.
///
/// # Cost
///
/// O(nD) time, no allocation.
///
/// ```
/// use point_sets::fingerprint;
/// let print = fingerprint(&[[0.0, 1.0]]);
/// assert_eq!(print.to_string(), print.full()[..16]);
/// assert_ne!(print, fingerprint(&[[-0.0, 1.0]]));
/// ```
pub fn fingerprint<const D: usize>(points: &[[f64; D]]) -> Fingerprint {
    let mut hash = Sha256::new();
    hash.update((D as u64).to_le_bytes());
    hash.update((points.len() as u64).to_le_bytes());
    let mut block = [0_u8; 8 * BLOCK];
    for coordinates in points.as_flattened().chunks(BLOCK) {
        for (bytes, coordinate) in block.chunks_exact_mut(8).zip(coordinates) {
            bytes.copy_from_slice(&coordinate.to_le_bytes());
        }
        hash.update(&block[..8 * coordinates.len()]);
    }
    Fingerprint(hash.finalize().into())
}

/// Coordinates hashed at a time.
const BLOCK: usize = 512;

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.full()[..16])
    }
}

impl fmt::Debug for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Fingerprint({})", self.full())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_dimension_count_and_bits() {
        // The SHA-256 that another program finds for the 32 bytes 2, 1, 0.0, 1.0.
        let expected = "9618fd714c1a8634f08f408c7fd84b96d2f658eabe35935e752efad031a516d5";
        assert_eq!(fingerprint(&[[0.0, 1.0]]).full(), expected);
        let none2 = fingerprint::<2>(&[]);
        let none3 = fingerprint::<3>(&[]);
        assert_ne!(none2, none3);
        assert_ne!(fingerprint(&[[1.0, 2.0]]), fingerprint(&[[2.0, 1.0]]));
    }

    #[test]
    fn blocks_do_not_show() {
        let points: Vec<[f64; 3]> = (0..1000).map(|i| [f64::from(i), 0.5, -1.0]).collect();
        let mut hash = Sha256::new();
        hash.update(3_u64.to_le_bytes());
        hash.update(1000_u64.to_le_bytes());
        for coordinate in points.as_flattened() {
            hash.update(coordinate.to_le_bytes());
        }
        assert_eq!(fingerprint(&points).as_bytes()[..], hash.finalize()[..]);
    }
}
