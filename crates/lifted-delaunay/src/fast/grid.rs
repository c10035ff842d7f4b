//! Sites sorted into the cells of a grid, cells in the order of repeated halving.

use super::Site;
use super::extent::Extent;
use super::part::Across;

/// Cells of a grid, by repeated halving of the longer side.
pub(super) struct Grid {
    /// Across which axis the cells were divided, level by level from the top.
    pub(super) levels: Vec<Across>,
    /// Where the sites of each cell begin, and one more at the end.
    pub(super) starts: Vec<u32>,
    columns: Ruler,
    rows: Ruler,
}

/// The part of a cell's number that one coordinate decides.
struct Ruler {
    low: f64,
    per_unit: f64,
    codes: Vec<u32>,
}

impl Ruler {
    #[inline(always)]
    fn code(&self, x: f64) -> u32 {
        // Never falls with x, whatever is rounded.
        let cell = (x / 2.0 - self.low) * self.per_unit;
        self.codes[(cell as usize).min(self.codes.len() - 1)]
    }
}

impl Grid {
    /// A grid of 2^`depth` cells over `extent`.
    pub(super) fn new(extent: &Extent, depth: u32) -> Self {
        let mut sides = extent.half_sides();
        let levels: Vec<Across> = (0..depth)
            .map(|_| {
                let across = if sides[0] > sides[1] {
                    Across::X
                } else {
                    Across::Y
                };
                sides[across as usize] /= 2.0;
                across
            })
            .collect();
        let ruler = |across: Across| {
            // The places, in a cell's number, of the digits of its column or row.
            let digits = levels.iter().rev().enumerate();
            let digits: Vec<usize> = digits
                .filter(|&(_, &level)| level == across)
                .map(|(place, _)| place)
                .collect();
            let spread = |cell: usize| {
                digits
                    .iter()
                    .enumerate()
                    .map(|(digit, place)| ((cell >> digit & 1) << place) as u32)
                    .sum()
            };
            let codes: Vec<u32> = (0..1 << digits.len()).map(spread).collect();
            let side = extent.half_sides()[across as usize];
            Ruler {
                low: extent.low[across as usize] / 2.0,
                per_unit: codes.len() as f64 / side,
                codes,
            }
        };
        let (columns, rows) = (ruler(Across::X), ruler(Across::Y));
        Self {
            levels,
            starts: vec![0; (1 << depth) + 1],
            columns,
            rows,
        }
    }

    #[inline(always)]
    fn cell(&self, at: [f64; 2]) -> usize {
        (self.columns.code(at[0]) | self.rows.code(at[1])) as usize
    }

    /// Copies sites into `sorted`, cell by cell.
    pub(super) fn sort(&mut self, sites: impl Iterator<Item = Site> + Clone, sorted: &mut [Site]) {
        let mut cells: Vec<u32> = Vec::with_capacity(sorted.len());
        for site in sites.clone() {
            let cell = self.cell(site.at);
            cells.push(cell as u32);
            self.starts[cell + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut self.starts {
            sum += *start;
            *start = sum;
        }
        let mut places = self.starts.clone();
        for (site, cell) in sites.zip(cells) {
            let place = &mut places[cell as usize];
            sorted[*place as usize] = site;
            *place += 1;
        }
    }
}
