//! Seeds that never depend on what else an experiment holds.

use crate::spec::Spec;
use sha2::{Digest, Sha256};

/// The seed of one cell of an experiment: one set, one size, one replicate.
///
/// A hash of its arguments alone, so adding a cell never changes another, and two cells draw unrelated
/// numbers. `spec` enters in canonical form.
///
/// ```
/// use point_sets::cell_seed;
/// let disc = "disc".parse()?;
/// assert_eq!(cell_seed(1, &disc, 100, 0), cell_seed(1, &disc, 100, 0));
/// assert_ne!(cell_seed(1, &disc, 100, 0), cell_seed(1, &disc, 100, 1));
/// # Ok::<(), point_sets::SpecError>(())
/// ```
pub fn cell_seed(seed: u64, spec: &Spec, n: usize, replicate: u64) -> u64 {
    hashed("cell", [seed, n as u64, replicate], &spec.to_string())
}

/// A seed for one `purpose` inside a set, unrelated to the set's own draws.
pub(crate) fn subseed(seed: u64, purpose: &str) -> u64 {
    hashed("subseed", [seed, 0, 0], purpose)
}

/// The first eight bytes of SHA-256. `domain` has no zero byte, so the zero byte after it ends it.
fn hashed(domain: &str, numbers: [u64; 3], text: &str) -> u64 {
    let mut hash = Sha256::new();
    hash.update(domain);
    hash.update([0]);
    for number in numbers {
        hash.update(number.to_le_bytes());
    }
    hash.update(text);
    let digest: [u8; 32] = hash.finalize().into();
    let (first, _) = digest.split_first_chunk().expect("32 bytes hold 8");
    u64::from_le_bytes(*first)
}
