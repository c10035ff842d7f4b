//! Points tested in blocks, a bit of a word for each.
//!
//! A test is a plain loop over a whole block, compiled for each width of vectors that the machine may have; `pulp` picks the one
//! to run. The arithmetic is the same in all.

/// The points of a block.
pub(crate) const BLOCK: usize = 64;

/// A block that begins with the points, which are at least one and at most [`BLOCK`].
#[inline(always)]
pub(crate) fn filled_up<const D: usize>(points: &[[f64; D]]) -> [[f64; D]; BLOCK] {
    let mut block = [points[0]; BLOCK];
    block[..points.len()].copy_from_slice(points);
    block
}

/// The bits of the first `len` points of a block, which are at least one.
#[inline(always)]
pub(crate) fn first_bits(len: usize) -> u64 {
    u64::MAX >> (BLOCK - len)
}

/// The places of the bits that are set, ascending.
#[inline(always)]
pub(crate) fn places(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (place < BLOCK).then_some(place)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_of_the_bits() {
        assert_eq!(places(0).count(), 0);
        assert!(places(1 << 63 | 0b1101).eq([0, 2, 3, 63]));
        assert!(places(u64::MAX).eq(0..BLOCK));
        assert!(places(first_bits(3)).eq(0..3));
    }
}
