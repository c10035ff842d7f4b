//! The points that may be on the next layer, and their hull.

use super::chain::Place;
use super::hull_tree::HullTree;
use super::outline::{Outline, Reach};
use super::shells::merge_onto;
use super::side::{Context, Lower, Upper};
use super::sorted::Entry;
use geometry_core::{Hull2, Kernel2, Observer, Point2, Step};

/// Points and the two halves of their hull.
pub(super) struct Active<'a, K, O> {
    context: Context<'a, K, O>,
    lower: HullTree<Lower>,
    upper: HullTree<Upper>,
    below: Half,
    above: Half,
    /// By place, whether the point has left.
    gone: Vec<bool>,
}

/// One half of the hull, from left to right.
#[derive(Default)]
struct Half {
    places: Vec<Place>,
    points: Vec<Point2>,
}

impl<'a, K: Kernel2, O: Observer> Active<'a, K, O> {
    /// No points yet.
    pub(super) fn new(mut context: Context<'a, K, O>) -> Self {
        let lower = HullTree::new(std::iter::empty(), &mut context);
        let upper = HullTree::new(std::iter::empty(), &mut context);
        Self {
            context,
            lower,
            upper,
            below: Half::default(),
            above: Half::default(),
            gone: vec![true],
        }
    }

    /// Whether no point is left.
    pub(super) fn is_empty(&self) -> bool {
        self.below.places.is_empty() && self.above.places.is_empty()
    }

    /// The lower and the upper half of the hull.
    pub(super) fn halves(&self) -> [&[Point2]; 2] {
        [&self.below.points, &self.above.points]
    }

    /// The shape of the hull.
    pub(super) fn outline(&self) -> Outline {
        Outline::of(&self.below.points, &self.above.points)
    }

    /// The points left.
    pub(super) fn left(&self) -> Vec<Entry> {
        let all = self.context.entries.iter().zip(&self.gone);
        all.filter(|(_, gone)| !**gone)
            .map(|(entry, _)| *entry)
            .collect()
    }

    /// The shape of the hull of `entries`. No point is active afterwards.
    pub(super) fn shape_of<'e>(&mut self, entries: impl Iterator<Item = &'e Entry>) -> Outline {
        let entries: Vec<Entry> = entries.copied().collect();
        self.restart(&entries, &[], None);
        let shape = self.outline();
        self.restart(&[], &[], None);
        shape
    }

    /// Starts again with the points `left` and `entries`. As long as the hull has `core` inside, points beyond it are on
    /// one half of the hull only.
    pub(super) fn restart(&mut self, left: &[Entry], entries: &[Entry], core: Option<&Outline>) {
        let mut all = vec![Entry::default()];
        merge_onto(&mut all, left, entries);
        self.gone.clear();
        self.gone.resize(all.len(), false);
        self.gone[0] = true;
        let mut reach = vec![Reach::Both; all.len()];
        if let Some(core) = core {
            core.reaches(&all[1..], &mut reach[1..], self.context.kernel);
        }
        self.context.entries = all;
        let places = |except: Reach| {
            let all = (0..).zip(&reach).skip(1);
            all.filter(move |(_, reach)| **reach != except)
                .map(|(place, _)| place)
        };
        self.lower = HullTree::new(places(Reach::Upper), &mut self.context);
        self.upper = HullTree::new(places(Reach::Lower), &mut self.context);
        self.read();
    }

    /// The hull.
    pub(super) fn ring(&self) -> Hull2 {
        let id = |&place: &Place| self.context.entries[place as usize].id;
        let (below, above) = (&self.below.places, &self.above.places);
        if let [only] = below[..] {
            return Hull2::Point(id(&only));
        }
        if below == above {
            return Hull2::Segment(below.iter().map(id).collect());
        }
        let inner = above.get(1..above.len().max(1) - 1).unwrap_or_default();
        let mut cycle = Vec::with_capacity(below.len() + inner.len());
        cycle.extend(below.iter().map(id));
        cycle.extend(inner.iter().rev().map(id));
        Hull2::Polygon(cycle)
    }

    /// Takes out the points of the hull, and notes by id the stage at which they leave.
    pub(super) fn peel(&mut self, stage: u32, stages: &mut [u32]) {
        for &place in self.below.places.iter().chain(&self.above.places) {
            self.gone[place as usize] = true;
            stages[self.context.entries[place as usize].id as usize] = stage;
        }
        self.upper
            .take_hull_and(&self.below.places, &mut self.context);
        self.lower
            .take_hull_and(&self.above.places, &mut self.context);
        self.read();
        self.context.observer.step(|| Step::Layer(stage));
    }

    /// Reads the hull from the trees.
    fn read(&mut self) {
        self.lower.read_hull(&mut self.below.places);
        self.upper.read_hull(&mut self.above.places);
        for half in [&mut self.below, &mut self.above] {
            half.points.clear();
            let entries = &self.context.entries;
            half.points.extend(
                half.places
                    .iter()
                    .map(|&place| entries[place as usize].point),
            );
        }
    }
}
