//! Sites sorted into the cells of a grid, which are numbered in the order of repeated halving.
//!
//! ```text
//!      10  11 | 14  15
//!       8   9 | 12  13      of a square, sixteen cells: halved across y, x, y, x;
//!      -------+--------     every aligned run of 2, 4 or 8 cells is a box
//!       2   3 |  6   7
//!       0   1 |  4   5
//! ```
//!
//! A column never falls as x grows, whatever is rounded: sites of different columns are strictly separated. Likewise
//! rows.

use super::halving::Extent;
use super::part::Across;
use super::site::{Site, Sited};

/// The cells, and where their sites are.
#[derive(Debug)]
pub(super) struct Grid {
    /// Across which axis the boxes of each level are halved; the first level is that of all cells.
    pub(super) levels: Vec<Across>,
    /// Where the sites of each cell begin, and one more at the end.
    pub(super) starts: Vec<u32>,
}

impl Grid {
    /// Copies `sites`, whose box is `extent`, into `sorted` cell by cell, about `average` in each.
    pub(super) fn sort(
        sites: impl Iterator<Item = Site> + Clone,
        extent: &Extent,
        average: usize,
        sorted: &mut [Site],
    ) -> Self {
        let depth = (sorted.len() / average).max(1).ilog2();
        let levels = halvings(extent, depth);
        let [columns, rows] = [Across::X, Across::Y].map(|axis| Ruler::new(axis, extent, &levels));
        let cell =
            |site: &Site| (columns.digits(site.at()[0]) | rows.digits(site.at()[1])) as usize;
        // First counts[i + 2] is the size of cell i; then counts[i + 1] is where it begins; at the end, where it ends.
        let mut counts = vec![0_u32; (1 << depth) + 2];
        for site in sites.clone() {
            counts[cell(&site) + 2] += 1;
        }
        let mut sum = 0;
        for count in &mut counts {
            sum += *count;
            *count = sum;
        }
        for site in sites {
            let place = &mut counts[cell(&site) + 1];
            sorted[*place as usize] = site;
            *place += 1;
        }
        counts.pop();
        Self {
            levels,
            starts: counts,
        }
    }

    /// The number of cells.
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of sites in the fullest cell.
    pub(super) fn most(&self) -> u32 {
        let sizes = self.starts.windows(2).map(|pair| pair[1] - pair[0]);
        sizes.max().unwrap_or(0)
    }
}

/// The longer side of each box is halved.
fn halvings(extent: &Extent, depth: u32) -> Vec<Across> {
    let mut sides = extent.half_sides();
    let halve_longer = |_| {
        let across = if sides[0] > sides[1] {
            Across::X
        } else {
            Across::Y
        };
        sides[across as usize] /= 2.0;
        across
    };
    (0..depth).map(halve_longer).collect()
}

/// What a coordinate says about the number of a cell.
struct Ruler {
    /// Half the lowest coordinate.
    low: f64,
    /// Columns for half a unit.
    per_half: f64,
    /// For each column, the binary digits that it decides, in their places.
    digits: Vec<u32>,
}

impl Ruler {
    fn new(axis: Across, extent: &Extent, levels: &[Across]) -> Self {
        let upwards = (0..).zip(levels.iter().rev());
        let places = upwards.filter(|&(_, &level)| level == axis);
        let places: Vec<u32> = places.map(|(place, _)| place).collect();
        let spread = |column: u32| {
            let bits = (0..).zip(&places);
            bits.map(|(bit, place)| (column >> bit & 1) << place).sum()
        };
        let digits: Vec<u32> = (0..1 << places.len()).map(spread).collect();
        let axis = axis as usize;
        Self {
            low: extent.low[axis] / 2.0,
            per_half: digits.len() as f64 / extent.half_sides()[axis],
            digits,
        }
    }

    /// Coordinates are halved so that no difference overflows. Where the side is zero, or so small that its reciprocal
    /// overflows, the product is infinite or NaN; the conversion takes these to the last column and the first, still in
    /// order.
    #[inline(always)]
    fn digits(&self, x: f64) -> u32 {
        let column = (x / 2.0 - self.low) * self.per_half;
        self.digits[(column as usize).min(self.digits.len() - 1)]
    }
}
