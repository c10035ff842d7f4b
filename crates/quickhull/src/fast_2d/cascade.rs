//! The regions that all points are tested against, chosen on a sample.

use super::ellipse::Ellipse;
use super::octagon::Octagon;
use super::polygon::{Corners, Polygon};
use super::region::Kept;
use super::sample::Sample;
use geometry_core::{Observer, Point2, Step};
use smallvec::SmallVec;

/// A sixteenth of the points, but about so many at most, are looked at for corners: enough that a better polygon
/// would save less time than finding it takes.
const MOST_SAMPLED: usize = 1 << 14;

/// With fewer points, all are looked at.
const SAMPLED_FROM: usize = 1 << 12;

/// Fewer corners than this may be close together, as those of a long and slanted set. So they are refined on a sample at once, and
/// if all points are looked at, after a pass, even if it threw away little.
pub(super) const ENOUGH: usize = 7;

/// With fewer points, a pass takes longer than sorting those that it throws away.
const FEW: usize = 24;

/// A region inside the polygons that holds many points and is cheap to test.
enum Core {
    Octagon(Octagon),
    Ellipse(Ellipse),
}

impl Core {
    /// Fills `kept`; see there.
    fn sift(&self, points: &[Point2], first: u32, kept: &mut Kept) {
        match self {
            Core::Octagon(octagon) => kept.fill(points, first, octagon),
            Core::Ellipse(ellipse) => kept.fill(points, first, ellipse),
        }
    }
}

/// One region after another, each for the points not in those before.
pub(super) struct Cascade {
    core: Option<Core>,
    polygons: SmallVec<[Polygon; 1]>,
    /// The corners of the last polygon.
    pub(super) corners: Corners,
}

impl Cascade {
    /// For these points; none if it would not pay.
    pub(super) fn of(points: &[Point2]) -> Option<Self> {
        if points.len() < FEW {
            return None;
        }
        let sample = sampled(points);
        let all_are_sampled = sample.is_all();
        let mut corners = Corners::of(sample)?;
        if corners.len() < 3 || corners.len() < ENOUGH && !all_are_sampled {
            corners = corners.refined(sample);
        }
        let polygon = Polygon::of(&corners)?;
        let mut cascade = Self {
            core: None,
            polygons: SmallVec::from_buf([polygon]),
            corners,
        };
        if all_are_sampled {
            return Some(cascade);
        }
        if !cascade.extend(sample) {
            return None;
        }
        cascade.add_core(sample);
        Some(cascade)
    }

    /// Puts a polygon in place of the last, which is about a part of it.
    pub(super) fn improve(&mut self, polygon: Polygon, corners: Corners) {
        self.polygons.pop();
        self.push(polygon, corners);
    }

    fn push(&mut self, polygon: Polygon, corners: Corners) {
        self.polygons.push(polygon);
        self.corners = corners;
    }

    /// Adds the polygons that pay on the sample. Returns whether any does.
    fn extend(&mut self, sample: Sample<'_>) -> bool {
        let mut kept = Kept::default();
        sample.in_parts(|points| kept.fill(points, 0, &self.polygons[0]));
        let mut before = sample.len();
        if kept.len() > before / 2 {
            return false;
        }
        while pays(before, kept.len(), &self.corners) {
            let corners = self.corners.refined(Sample::all(kept.points()));
            let Some(polygon) = Polygon::of(&corners) else {
                break;
            };
            before = kept.len();
            kept.thin(&polygon);
            self.push(polygon, corners);
        }
        true
    }

    /// Adds the core, if a quarter of the sample lies in it. If more than half does, the first polygon has little left
    /// to do.
    fn add_core(&mut self, sample: Sample<'_>) {
        let Some(polygon) = self.polygons.last() else {
            return;
        };
        let few = sample.fewer(1024);
        let centres = [mean(self.corners.as_slice()), median(sample)];
        let cores = centres.into_iter().flat_map(|centre| {
            let ellipse = Ellipse::inside(polygon, &self.corners, centre).map(Core::Ellipse);
            let octagon = Octagon::inside(polygon, &self.corners, centre).map(Core::Octagon);
            ellipse.into_iter().chain(octagon)
        });
        let tried = cores.map(|core| {
            let (mut kept, mut left) = (Kept::default(), 0);
            few.in_parts(|points| {
                core.sift(points, 0, &mut kept);
                left += kept.len();
                kept.clear();
            });
            (left, core)
        });
        let best = tried.min_by_key(|(left, _)| *left);
        let Some((left, core)) = best else {
            return;
        };
        let tried = few.len();
        if left <= tried / 2 && self.polygons.len() > 1 {
            self.polygons.remove(0);
        }
        if left <= tried - tried / 4 {
            self.core = Some(core);
        }
    }

    /// Adds to `kept` those of the points that are not certain to lie in any region; the first point's index is `first`.
    pub(super) fn sift<O: Observer>(
        &self,
        points: &[Point2],
        first: u32,
        kept: &mut Kept,
        observer: &mut O,
    ) {
        let range = first..first + points.len() as u32;
        let [only] = &self.polygons[..] else {
            return self.sift_in_steps(points, range, kept, observer);
        };
        match &self.core {
            Some(_) => self.sift_in_steps(points, range, kept, observer),
            None => {
                kept.fill(points, first, only);
                report(range, kept.ids(), observer);
            }
        }
    }

    /// In steps that fit the first cache.
    fn sift_in_steps<O: Observer>(
        &self,
        points: &[Point2],
        range: std::ops::Range<u32>,
        kept: &mut Kept,
        observer: &mut O,
    ) {
        const STEP: usize = 4096;
        let mut step = Kept::default();
        for (points, first) in points.chunks(STEP).zip(range.step_by(STEP)) {
            let mut polygons = self.polygons.iter();
            match &self.core {
                Some(core) => core.sift(points, first, &mut step),
                None => step.fill(points, first, polygons.next().expect("never empty")),
            }
            report(first..first + points.len() as u32, step.ids(), observer);
            for polygon in polygons {
                step.thin_reported(polygon, observer);
            }
            kept.append(&step);
            step.clear();
        }
    }
}

impl Kept {
    /// [`thin`](Self::thin), and tells the observer.
    pub(super) fn thin_reported<O: Observer>(&mut self, polygon: &Polygon, observer: &mut O) {
        let ids = if O::ACTIVE {
            self.ids().to_vec()
        } else {
            Vec::new()
        };
        self.thin(polygon);
        report(ids, self.ids(), observer);
    }
}

/// Whether refining the corners and one more pass pay, after one that kept `after` of `before` points.
pub(super) fn pays(before: usize, after: usize, corners: &Corners) -> bool {
    after > 6 * corners.len() && after < before - before / 4
}

/// A sixteenth of the points, at most [`MOST_SAMPLED`]; all if they are few.
fn sampled(points: &[Point2]) -> Sample<'_> {
    if points.len() < SAMPLED_FROM {
        Sample::all(points)
    } else {
        Sample::some(points, MOST_SAMPLED.min(points.len() / 16))
    }
}

fn mean(points: &[Point2]) -> Point2 {
    let part = 1.0 / points.len() as f64;
    points
        .iter()
        .fold([0.0; 2], |[x, y], p| [x + part * p[0], y + part * p[1]])
}

/// The median of each coordinate, of a few of the points.
fn median(sample: Sample<'_>) -> Point2 {
    let mut few = SmallVec::<[Point2; 64]>::new();
    sample
        .fewer(60)
        .in_parts(|points| few.extend_from_slice(points));
    [0, 1].map(|axis| {
        few.sort_unstable_by(|p, q| p[axis].total_cmp(&q[axis]));
        few.get(few.len() / 2).map_or(0.0, |point| point[axis])
    })
}

/// Tells of points looked at and of those dropped. Both lists ascend, and the second is part of the first.
fn report<O: Observer>(looked_at: impl IntoIterator<Item = u32>, kept: &[u32], observer: &mut O) {
    if !O::ACTIVE {
        return;
    }
    let mut kept = kept.iter().copied().peekable();
    for id in looked_at {
        observer.step(|| Step::Visit(id));
        if kept.next_if_eq(&id).is_none() {
            observer.step(|| Step::Discard(id));
        }
    }
}
