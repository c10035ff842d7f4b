//! Polygons that have other points inside for certain.

use super::sorted::Entry;
use geometry_core::{Kernel2, Point2, Sign};

/// The most vertices of one half of an outline.
const MOST: usize = 64;

/// A polygon as a lower and an upper chain, both from left to right with the same ends.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    lower: Vec<Point2>,
    upper: Vec<Point2>,
}

impl Outline {
    /// Some of the vertices of the hull with these halves.
    pub(super) fn of(lower: &[Point2], upper: &[Point2]) -> Self {
        Self {
            lower: thinned(lower),
            upper: thinned(upper),
        }
    }

    /// This outline shrunk about its centre so that about half of `entries` lie outside. `None` if it cannot be.
    ///
    /// All of it is rounded: what lies inside is asked later.
    pub(super) fn halving(&self, entries: &[Entry]) -> Option<Self> {
        let center = self.center();
        let scale = self.middle_size(center, entries);
        if !(scale > 0.0 && scale < 1.0) {
            return None;
        }
        let shrunk = |chain: &[Point2]| -> Vec<Point2> {
            let point = |q: &Point2| [0, 1].map(|i| scale * q[i] + (1.0 - scale) * center[i]);
            chain.iter().map(point).collect()
        };
        let [lower, upper] = [&self.lower, &self.upper].map(|chain| shrunk(chain));
        let mut coordinates = lower.iter().chain(&upper).flatten();
        let finite = coordinates.all(|x| x.is_finite());
        finite.then_some(Self { lower, upper })
    }

    /// The median, over a sample of `entries`, of the factor that puts this outline through the point when it grows from
    /// `center`.
    fn middle_size(&self, center: Point2, entries: &[Entry]) -> f64 {
        const SAMPLE: usize = 48;
        let lines: Vec<Point2> = [&self.lower, &self.upper]
            .into_iter()
            .flat_map(|chain| chain.windows(2))
            .filter_map(|edge| reciprocal_line(center, edge[0], edge[1]))
            .collect();
        let size = |entry: &Entry| {
            let [x, y] = [0, 1].map(|axis| entry.point[axis] - center[axis]);
            lines
                .iter()
                .fold(0.0_f64, |most, line| most.max(line[0] * x + line[1] * y))
        };
        let step = entries.len().div_ceil(SAMPLE).max(1);
        let mut sizes: Vec<f64> = entries
            .iter()
            .skip(step / 2)
            .step_by(step)
            .map(size)
            .collect();
        let middle = sizes.len() / 2;
        *sizes.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// The mean of the vertices.
    fn center(&self) -> Point2 {
        let vertices = self.lower.iter().chain(&self.upper);
        let count = (self.lower.len() + self.upper.len()) as f64;
        vertices.fold([0.0; 2], |sum, q| [0, 1].map(|i| sum[i] + q[i] / count))
    }

    /// Moves the entries strictly inside to the front of `entries`, and the others to the front of `outside`, which is
    /// as long. Returns how many are inside. All are in lexicographic order and stay so.
    pub(super) fn split<K: Kernel2>(
        &self,
        entries: &mut [Entry],
        outside: &mut [Entry],
        kernel: &K,
    ) -> usize {
        let mut between = Between::new([&self.lower, &self.upper]);
        // A point of an upright edge on the left is between the chains, but not inside.
        let leftmost = self.lower.first().map_or(f64::MAX, |q| q[0]);
        let mut inner = 0;
        for place in 0..entries.len() {
            // Both are written and one counts: where a point lies, no branch could foresee.
            let entry = entries[place];
            outside[place - inner] = entry;
            entries[inner] = entry;
            let is_between = between.holds(entry.point, Sign::Positive, kernel);
            inner += usize::from(is_between & (entry.point[0] > leftmost));
        }
        inner
    }

    /// Finds the reach of `entries` outside, which are in lexicographic order.
    pub(super) fn reaches<K: Kernel2>(&self, entries: &[Entry], reach: &mut [Reach], kernel: &K) {
        let mut lower = &self.lower[..];
        let leftmost = lower.first().map_or(f64::MAX, |q| q[0]);
        for (entry, reach) in entries.iter().zip(reach) {
            let edge = edge_at(&mut lower, entry.point[0]);
            *reach = match edge {
                Some([a, b]) if entry.point[0] > leftmost => {
                    if kernel.orient(a, b, entry.point).is_positive() {
                        Reach::Upper
                    } else {
                        Reach::Lower
                    }
                }
                _ => Reach::Both,
            };
        }
    }

    /// Whether the polygon with these halves, lower and upper, certainly holds this one.
    pub(super) fn is_within<K: Kernel2>(&self, hull: [&[Point2]; 2], kernel: &K) -> bool {
        [&self.lower, &self.upper].into_iter().all(|chain| {
            let mut between = Between::new(hull);
            chain.iter().all(|&q| between.holds(q, Sign::Zero, kernel))
        })
    }

    /// Whether this outline certainly holds `other`.
    pub(super) fn holds<K: Kernel2>(&self, other: &Self, kernel: &K) -> bool {
        other.is_within([&self.lower, &self.upper], kernel)
    }
}

/// Which halves of a hull a point may be on, as long as the hull has an outline inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// It lies below the outline.
    Lower,
    /// It lies above the outline.
    Upper,
    /// It lies to the left or right of all of it.
    Both,
}

/// The line through a and b as the vector (u, v) with u x + v y = 1 on it, from the centre.
fn reciprocal_line(center: Point2, a: Point2, b: Point2) -> Option<Point2> {
    let [a, b] = [a, b].map(|p| [0, 1].map(|axis| p[axis] - center[axis]));
    let area = a[0] * b[1] - a[1] * b[0];
    let line = [(b[1] - a[1]) / area, (a[0] - b[0]) / area];
    line.iter().all(|x| x.is_finite()).then_some(line)
}

/// At most [`MOST`] points of a chain, its ends among them.
fn thinned(chain: &[Point2]) -> Vec<Point2> {
    let step = chain.len().div_ceil(MOST - 1).max(1);
    let mut few: Vec<Point2> = chain.iter().copied().step_by(step).collect();
    if chain.len() % step != 1 % step {
        few.extend(chain.last());
    }
    few
}

/// Asks whether points, given from left to right, lie between two chains.
struct Between<'a> {
    lower: &'a [Point2],
    upper: &'a [Point2],
}

impl<'a> Between<'a> {
    fn new([lower, upper]: [&'a [Point2]; 2]) -> Self {
        Self { lower, upper }
    }

    /// Whether the point turns at least as much as `least` from the edge below it and the edge above it.
    #[inline(always)]
    fn holds<K: Kernel2>(&mut self, point: Point2, least: Sign, kernel: &K) -> bool {
        let below = edge_at(&mut self.lower, point[0]);
        let above = edge_at(&mut self.upper, point[0]);
        match (below, above) {
            (Some([a, b]), Some([c, d])) => {
                (kernel.orient(a, b, point) >= least) & (kernel.orient(d, c, point) >= least)
            }
            _ => false,
        }
    }
}

/// The edge of `chain` over or under x, an edge that is not upright. Drops edges to the left of it.
#[inline(always)]
fn edge_at(chain: &mut &[Point2], x: f64) -> Option<[Point2; 2]> {
    while let [_, b, ..] = chain
        && b[0] <= x
    {
        *chain = &chain[1..];
    }
    match chain {
        [a, b, ..] if a[0] <= x => Some([*a, *b]),
        _ => None,
    }
}
