//! The hull of the points kept: Andrew's monotone chain, one chain on each side of the line through the ends.
//!
//! ```text
//!              . upper .
//!          .               .
//!       left ------------- right        each point is sorted into one side, and scanned once
//!            .           .
//!              . lower .
//! ```
//!
//! Three or four points need neither sort nor scan ([`few`]).

use super::few;
use super::order::Keys;
use super::region::INLINE;
use geometry_core::kernel::lexicographic;
use geometry_core::{Boundary, Hull2, Kernel2, Observer, Point2, Sign, Step};
use smallvec::SmallVec;

/// The points that may be vertices.
#[derive(Clone, Copy)]
pub(super) struct Candidates<'a> {
    pub(super) points: &'a [Point2],
    /// Their indices in the caller's slice, ascending; `None` if they are all of it.
    pub(super) ids: Option<&'a [u32]>,
}

impl Candidates<'_> {
    fn id(&self, place: u32) -> u32 {
        self.ids.map_or(place, |ids| ids[place as usize])
    }

    fn ids_of(&self, mut places: Vec<u32>) -> Vec<u32> {
        if self.ids.is_some() {
            for id in &mut places {
                *id = self.id(*id);
            }
        }
        places
    }

    /// The polygon with corners at these places.
    fn hull<O: Observer>(&self, places: Vec<u32>, observer: &mut O) -> Hull2 {
        let ids = self.ids_of(places);
        let next = ids.iter().cycle().skip(1);
        for (&from, &to) in ids.iter().zip(next) {
            observer.step(|| Step::Edge(from, to));
        }
        Hull2::Polygon(ids)
    }
}

/// The hull of the candidates.
pub(super) fn hull_of<K: Kernel2, O: Observer>(
    candidates: Candidates<'_>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Hull2 {
    let points = candidates.points;
    if let Some(places) = few::corners(points, kernel) {
        for place in 0..points.len() as u32 {
            observer.step(|| Step::Push(candidates.id(place)));
            if O::ACTIVE && !places.contains(&place) {
                observer.step(|| Step::Pop(candidates.id(place)));
            }
        }
        return candidates.hull(places, observer);
    }
    let Some((left, right)) = ends(points) else {
        return Hull2::Empty;
    };
    if left == right {
        return Hull2::Point(candidates.id(left));
    }
    let [least, most] = [left, right].map(|place| points[place as usize][0]);
    let keys = Keys::new(points.len(), least, most);
    let mut list = SmallVec::<[u64; INLINE]>::new();
    list.resize(points.len(), 0);
    let mut sides = Sides::of(points, (left, right), boundary, keys, &mut list, kernel);
    let flat = sides.lower == 0 && sides.upper == 0;
    let [lower, upper] = sides.sorted(points, keys);
    let mut chain = Chain {
        candidates,
        boundary,
        kernel,
        observer,
        // The left end is pushed again at the end.
        places: Vec::with_capacity((lower.len() + upper.len() + 3).min(1024)),
    };
    chain.places.push(left);
    if flat {
        chain
            .places
            .extend(lower.iter().map(|&key| keys.place(key) as u32));
        chain.places.push(right);
    } else {
        chain.extend(lower.iter().map(|&key| keys.place(key) as u32), right);
        chain.extend(upper.iter().rev().map(|&key| keys.place(key) as u32), left);
        chain.places.pop();
    }
    chain.into_hull(flat)
}

/// The places of the lexicographically smallest and largest points, of copies the first.
fn ends(points: &[Point2]) -> Option<(u32, u32)> {
    let (&first, rest) = points.split_first()?;
    let (mut left, mut right) = ((first, 0), (first, 0));
    for (place, &point) in (1..).zip(rest) {
        if point[0] <= left.0[0] && lexicographic(point, left.0).is_lt() {
            left = (point, place);
        }
        if point[0] >= right.0[0] && lexicographic(point, right.0).is_gt() {
            right = (point, place);
        }
    }
    Some((left.1, right.1))
}

/// The keys of the points on the two sides of the line through the ends: those of the lower side at the front, those of
/// the upper side at the back, of a list that has room for all.
struct Sides<'a> {
    keys: &'a mut [u64],
    lower: usize,
    upper: usize,
    /// Under [`Boundary::All`], the keys of points on the line.
    on_line: Vec<u64>,
}

impl<'a> Sides<'a> {
    fn of<K: Kernel2>(
        points: &[Point2],
        (left, right): (u32, u32),
        boundary: Boundary,
        keys: Keys,
        list: &'a mut [u64],
        kernel: &K,
    ) -> Self {
        let [left, right] = [left, right].map(|place| place as usize);
        let [a, b] = [left, right].map(|place| points[place]);
        let mut on_line = Vec::new();
        let (mut front, mut back) = (0, points.len());
        for (place, &point) in points.iter().enumerate() {
            // The ends are on the line, which takes long to prove.
            if place == left || place == right {
                continue;
            }
            let side = kernel.orient(a, b, point);
            let key = keys.key(point[0], place);
            if side.is_zero() {
                if boundary == Boundary::All && point != a && point != b {
                    on_line.push(key);
                }
                continue;
            }
            // The side is a coin toss, and a branch would guess it wrong every other time. So both ends are written,
            // and one of them moves.
            let below = usize::from(side.is_negative());
            list[front] = key;
            list[back - 1] = key;
            front += below;
            back -= 1 - below;
        }
        Self {
            lower: front,
            upper: points.len() - back,
            keys: list,
            on_line,
        }
    }

    /// Each side in lexicographic order, one key a point. Points on the line belong to the side that has no others, to the
    /// lower one if neither has; if both have, they are inside.
    fn sorted(&mut self, points: &[Point2], keys: Keys) -> [&[u64]; 2] {
        let Self {
            keys: list,
            lower,
            upper,
            on_line,
        } = self;
        let (front, back) = list.split_at_mut(*lower);
        let back_start = back.len() - *upper;
        let (mut below, mut above) = (front, &mut back[back_start..]);
        if below.is_empty() {
            below = on_line;
        } else if above.is_empty() {
            above = on_line;
        }
        let [lower, upper] = [&mut below, &mut above].map(|side| keys.sort(points, side));
        [&below[..lower], &above[..upper]]
    }
}

/// The boundary as far as it is known, anticlockwise from the left end.
struct Chain<'a, K, O> {
    candidates: Candidates<'a>,
    boundary: Boundary,
    kernel: &'a K,
    observer: &'a mut O,
    places: Vec<u32>,
}

impl<K: Kernel2, O: Observer> Chain<'_, K, O> {
    /// Appends the chain of the points at `places`, which begins at the present end, and then the point at `end`.
    fn extend(&mut self, places: impl Iterator<Item = u32>, end: u32) {
        let points = self.candidates.points;
        let at = |place: u32| points[place as usize];
        let floor = self.places.len();
        // The last two points of the chain, without a way through memory; the first of them counts only if there is one.
        let mut last = at(self.places[floor - 1]);
        let mut before = last;
        for place in places.chain([end]) {
            let point = at(place);
            while self.places.len() > floor
                && !keeps(self.boundary, self.kernel.orient(before, last, point))
            {
                let popped = self.places.pop().map(|place| self.candidates.id(place));
                self.observer.step(|| Step::Pop(popped.unwrap_or_default()));
                last = before;
                if let [.., before_last, _] = self.places[floor - 1..] {
                    before = at(before_last);
                }
            }
            let id = self.candidates.id(place);
            self.observer.step(|| Step::Push(id));
            self.places.push(place);
            (before, last) = (last, point);
        }
    }

    /// The hull, whose vertices are all the points of the chain, or its ends if it is flat.
    fn into_hull(self, flat: bool) -> Hull2 {
        if flat || self.places.len() == 2 {
            return Hull2::Segment(self.candidates.ids_of(self.places));
        }
        self.candidates.hull(self.places, self.observer)
    }
}

/// Whether the middle point of a turn of this orientation stays on an anticlockwise boundary.
fn keeps(boundary: Boundary, turn: Sign) -> bool {
    match boundary {
        Boundary::Extreme => turn.is_positive(),
        Boundary::All => !turn.is_negative(),
    }
}
