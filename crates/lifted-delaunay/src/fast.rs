//! Delaunay triangulations by divide and conquer.

mod extent;
mod few;
mod grid;
mod merge;
mod part;
mod rings;

use extent::Extent;
use geometry_core::exact::Unit;
use geometry_core::{HullError, Point2, Points, Triangulation};
use grid::Grid;
use part::{Across, Part};
use rings::{Half, Rings};

/// Where it departs from Guibas and Stolfi, and from Dwyer, and why.
pub const DEPARTURES: &[&str] = &[
    "sets are halved across their longer side, by a grid where they are large, instead of into rows of cells",
    "four extremes of a part are kept with their edges, so that parts join across either axis without a search",
    "edges are pairs of halves in one array, and there is no dual",
    "ties are broken as if points were lowered by infinitesimals by lexicographic rank",
];

/// A point and its index in the caller's slice.
#[derive(Clone, Copy, Debug)]
struct Site {
    at: Point2,
    id: u32,
}

/// Sets up to this size are halved without a grid.
const FEW: usize = 1 << 9;

/// The average number of sites in a cell of a grid.
const CELL: usize = 8;

/// The Delaunay triangulation.
pub fn fast_delaunay(points: Points<'_, 2>) -> Result<Triangulation, HullError> {
    let n = points.len();
    let named = points.as_slice().iter().zip(0..);
    let named = named.map(|(&at, id)| Site { at, id });
    let mut halves = vec![Half::default(); 6 * n];
    let rings = Rings::new(&mut halves);
    let unit = Unit::of(points.as_slice());
    let mut sites;
    let mut triangulator;
    let part = if n <= FEW {
        sites = named.collect::<Vec<_>>();
        triangulator = Triangulator {
            sites: &mut sites,
            rings,
            unit,
        };
        triangulator.solve(0, n)
    } else {
        sites = vec![
            Site {
                at: [0.0; 2],
                id: 0
            };
            n
        ];
        let extent = Extent::of(points.as_slice().iter().copied());
        let mut grid = Grid::new(&extent, (n / CELL).ilog2());
        grid.sort(named, &mut sites);
        triangulator = Triangulator {
            sites: &mut sites,
            rings,
            unit,
        };
        triangulator.solve_cells(0, &grid, 0, grid.starts.len() - 1, 0)
    };
    let Some(part) = part else {
        return Ok(Triangulation::default());
    };
    let out = part.first[0].out;
    if out == rings::NONE {
        return Ok(Triangulation::default());
    }
    let Triangulator {
        mut rings, sites, ..
    } = triangulator;
    rings.drop_outside(out);
    let names: Vec<u32> = sites.iter().map(|site| site.id).collect();
    let triangles = rings.triangles(2 * n, |v| names[v as usize]);
    Ok(Triangulation::new(triangles))
}

struct Triangulator<'a> {
    sites: &'a mut [Site],
    rings: Rings<'a>,
    unit: Unit,
}

impl Triangulator<'_> {
    fn solve(&mut self, from: usize, to: usize) -> Option<Part> {
        let sites = &mut self.sites[from..to];
        match sites.len() {
            0 => return None,
            1 => return Some(Part::point(from as u32)),
            _ => {}
        }
        let extent = Extent::of(sites.iter().map(|site| site.at));
        if extent.is_point() {
            let least = (0..sites.len()).min_by_key(|&i| sites[i].id).unwrap_or(0);
            sites.swap(0, least);
            return Some(Part::point(from as u32));
        }
        let first = from as u32;
        match sites.len() {
            2 => return Some(few::edge(self.sites, &mut self.rings, [first, first + 1])),
            3 if distinct(sites) => {
                return Some(few::triangle(
                    self.sites,
                    &mut self.rings,
                    [first, first + 1, first + 2],
                ));
            }
            4..=FEW | 3 => {}
            _ => return self.solve_by_grid(from, to, &extent),
        }
        let across = extent.longer();
        let middle = extent.middle(across);
        let mut mid = partition(sites, across, middle);
        let smaller = mid.min(sites.len() - mid);
        if sites.len() > 32 && smaller < sites.len() / 8 {
            mid = halve(sites, across, &extent);
        }
        let mid = from + mid;
        let left = self.solve(from, mid);
        let right = self.solve(mid, to);
        self.join(left, right, across)
    }

    fn join(&mut self, left: Option<Part>, right: Option<Part>, across: Across) -> Option<Part> {
        match (left, right) {
            (Some(left), Some(right)) => Some(merge::merge(
                self.sites,
                &mut self.rings,
                self.unit,
                [&left, &right],
                across,
            )),
            (part, None) | (None, part) => part,
        }
    }

    fn solve_by_grid(&mut self, from: usize, to: usize, extent: &Extent) -> Option<Part> {
        let sites = &mut self.sites[from..to];
        let depth = (sites.len() / CELL).ilog2();
        let mut grid = Grid::new(extent, depth);
        let unsorted = sites.to_vec();
        grid.sort(unsorted.iter().copied(), sites);
        let largest = grid.starts.windows(2).map(|pair| pair[1] - pair[0]).max();
        if largest.unwrap_or(0) as usize > sites.len() / 2 {
            // Clustered.
            let across = extent.longer();
            let mid = from + halve(sites, across, extent);
            let left = self.solve(from, mid);
            let right = self.solve(mid, to);
            return self.join(left, right, across);
        }
        self.solve_cells(from, &grid, 0, grid.starts.len() - 1, 0)
    }

    fn solve_cells(
        &mut self,
        base: usize,
        grid: &Grid,
        from: usize,
        to: usize,
        level: usize,
    ) -> Option<Part> {
        let (start, end) = (grid.starts[from] as usize, grid.starts[to] as usize);
        if end - start <= 3 || to - from == 1 {
            return self.solve(base + start, base + end);
        }
        let middle = from + (to - from) / 2;
        let left = self.solve_cells(base, grid, from, middle, level + 1);
        let right = self.solve_cells(base, grid, middle, to, level + 1);
        self.join(left, right, grid.levels[level])
    }
}

fn distinct(sites: &[Site]) -> bool {
    let [a, b, c] = [0, 1, 2].map(|i| sites[i].at);
    a != b && b != c && c != a
}

/// Moves the sites up to `middle` to the front, and returns how many.
fn partition(sites: &mut [Site], across: Across, middle: f64) -> usize {
    let mut front = 0;
    for i in 0..sites.len() {
        let site = sites[i];
        sites[i] = sites[front];
        sites[front] = site;
        front += usize::from(site.at[across as usize] <= middle);
    }
    front
}

/// Divides at about the median.
fn halve(sites: &mut [Site], across: Across, extent: &Extent) -> usize {
    let axis = across as usize;
    let half = sites.len() / 2;
    let by_axis = |a: &Site, b: &Site| a.at[axis].total_cmp(&b.at[axis]);
    let (_, median, _) = sites.select_nth_unstable_by(half, by_axis);
    let median = median.at[axis];
    if median < extent.high[axis] {
        partition(sites, across, median)
    } else {
        partition(sites, across, median.next_down())
    }
}
