//! A point and its index: what vertices are places of.
//!
//! An array rather than a struct, so that the memory of sites can be lent to triangles when they are not needed any more, and
//! comes zeroed from the system: a page that is touched for the first time takes longer than to sort what is on it.

use geometry_core::Point2;

/// The bits of both coordinates, and the index in the caller's slice.
pub(super) type Site = [u64; 3];

/// What a [`Site`] says.
pub(super) trait Sited {
    fn new(at: Point2, id: u32) -> Self;
    fn at(&self) -> Point2;
    fn id(&self) -> u32;
}

impl Sited for Site {
    #[inline(always)]
    fn new([x, y]: Point2, id: u32) -> Self {
        [x.to_bits(), y.to_bits(), u64::from(id)]
    }

    #[inline(always)]
    fn at(&self) -> Point2 {
        [f64::from_bits(self[0]), f64::from_bits(self[1])]
    }

    #[inline(always)]
    fn id(&self) -> u32 {
        self[2] as u32
    }
}

/// The memory of sites, as room for two triangles a site.
pub(super) fn room_for_triangles(sites: &mut [Site]) -> &mut [[u32; 3]] {
    bytemuck::cast_slice_mut(sites)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_site_says_what_it_was_made_of() {
        let mut sites = [
            Site::new([-0.0, 1e-320], 7),
            Site::new([f64::MAX, -1.0], u32::MAX),
        ];
        assert_eq!(sites.map(|site| site.id()), [7, u32::MAX]);
        assert_eq!(
            sites[0].at().map(f64::to_bits),
            [-0.0, 1e-320].map(f64::to_bits)
        );
        assert_eq!(sites[1].at(), [f64::MAX, -1.0]);
        assert_eq!(room_for_triangles(&mut sites).len(), 4);
    }
}
