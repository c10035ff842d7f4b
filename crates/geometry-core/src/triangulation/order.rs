//! The canonical order of triangles, by counting, in two steps that can be shared out.
//!
//! 1. Triangles are dealt into *ranges*, by the high bits of their first corners: in shares, if there are several.
//! 2. Each range, collected from all shares, is dealt into *stars*, the triangles with one first corner, and these few are sorted by
//!    comparison.
//!
//! Two short steps rather than one long one: the places written to at any time stay in the cache. If there is only one range,
//! step 1 deals by the second corners instead, so that stars are in order before they are sorted: without a jump that nothing
//! could foresee.
//!
//! ```
//! use geometry_core::triangulation::order::{Dealt, Keys};
//!
//! let shares = [vec![[5, 6, 7], [0, 2, 3]], vec![[0, 1, 2]]];
//! let keys = Keys::up_to(5, 3).expect("few numbers for so many triangles");
//! let mut rooms = shares.clone();
//! let dealt: Vec<Dealt> =
//!     shares.iter().zip(&mut rooms).map(|(share, room)| Dealt::of(share, keys, room)).collect();
//! let mut sorted = [[0; 3]; 3];
//! keys.sort(&dealt, &mut sorted);
//! assert_eq!(sorted, [[0, 1, 2], [0, 2, 3], [5, 6, 7]]);
//! ```

/// Triangles are sorted by counting if there is one for every so many values of their first corners.
const MOST_GAPS: usize = 8;

/// First corners with equal bits above these are in one range.
const RANGE_BITS: u32 = 12;

/// What the first corners of triangles can be.
#[derive(Clone, Copy, Debug)]
pub struct Keys {
    largest: u32,
}

impl Keys {
    /// Those up to `largest`; none if `count` triangles are too few for it, or too many, to be sorted by counting.
    pub fn up_to(largest: u32, count: usize) -> Option<Self> {
        let is_dense = largest as usize / MOST_GAPS <= count;
        let fits = u32::try_from(count).is_ok();
        (is_dense && fits).then_some(Self { largest })
    }

    /// The ranges, and for each the part of `sorted` where its triangles go.
    ///
    /// # Panics
    ///
    /// If `sorted` is shorter than all that was dealt.
    pub fn ranges_of<'s>(
        self,
        dealt: &[Dealt],
        mut sorted: &'s mut [[u32; 3]],
    ) -> Vec<(usize, &'s mut [[u32; 3]])> {
        let mut ranges = Vec::with_capacity(self.last_range() + 1);
        for range in 0..=self.last_range() {
            let len = dealt.iter().map(|share| share.range(range).len()).sum();
            let (here, others) = sorted.split_at_mut(len);
            ranges.push((range, here));
            sorted = others;
        }
        ranges
    }

    /// Step 2: puts all triangles into `sorted` in order.
    ///
    /// # Panics
    ///
    /// If `sorted` is shorter than all that was dealt.
    pub fn sort(self, dealt: &[Dealt], sorted: &mut [[u32; 3]]) {
        for (range, sorted) in self.ranges_of(dealt, sorted) {
            self.sort_range(range, dealt, sorted);
        }
    }

    /// Step 2, for one range: puts its triangles, from all shares, into `sorted` in order.
    ///
    /// # Panics
    ///
    /// If `sorted` is shorter than the range.
    pub fn sort_range(self, range: usize, dealt: &[Dealt], sorted: &mut [[u32; 3]]) {
        let rest = self.largest as usize - (range << RANGE_BITS);
        let largest_star = rest.min((1 << RANGE_BITS) - 1);
        let star = |corners: &[u32; 3]| corners[0] as usize % (1 << RANGE_BITS);
        let shares = || dealt.iter().map(|share| share.range(range));
        let ends = place_by_key(shares, sorted, largest_star, star);
        sort_stars(sorted, &ends);
    }

    /// The largest second corner, if the triangles are to be dealt by these.
    fn second_corners_of(self, triangles: &[[u32; 3]]) -> Option<usize> {
        if self.last_range() > 0 {
            return None;
        }
        let largest = triangles.iter().map(|corners| corners[1]).max()? as usize;
        (largest / MOST_GAPS <= triangles.len()).then_some(largest)
    }

    fn last_range(self) -> usize {
        range_of(&[self.largest; 3])
    }
}

fn range_of(corners: &[u32; 3]) -> usize {
    (corners[0] >> RANGE_BITS) as usize
}

/// Triangles, range by range.
#[derive(Debug)]
pub struct Dealt<'a> {
    triangles: &'a [[u32; 3]],
    /// Where each range ends.
    ends: Vec<u32>,
}

impl<'a> Dealt<'a> {
    /// Step 1: deals `triangles`, each of which begins with its smallest corner, into `room`, which is as long.
    ///
    /// # Panics
    ///
    /// If `room` is shorter, or a first corner is not among the keys.
    pub fn of(triangles: &[[u32; 3]], keys: Keys, room: &'a mut [[u32; 3]]) -> Self {
        let share = || std::iter::once(triangles);
        let ends = match keys.second_corners_of(triangles) {
            Some(largest) => {
                place_by_key(share, room, largest, |corners| corners[1] as usize);
                vec![triangles.len() as u32]
            }
            None => place_by_key(share, room, keys.last_range(), range_of),
        };
        Self {
            triangles: room,
            ends,
        }
    }

    fn range(&self, range: usize) -> &'a [[u32; 3]] {
        let end = |range: usize| self.ends[range] as usize;
        let start = range.checked_sub(1).map_or(0, end);
        &self.triangles[start..end(range)]
    }
}

/// Copies triangles to `to` in the order of their keys, which are at most `largest`. Returns where the triangles of each key
/// end.
#[inline(always)]
pub(crate) fn place_by_key<'f, I: Iterator<Item = &'f [[u32; 3]]>>(
    from: impl Fn() -> I,
    to: &mut [[u32; 3]],
    largest: usize,
    key: impl Fn(&[u32; 3]) -> usize,
) -> Vec<u32> {
    // First places[k + 1] is the number of triangles with key k; then places[k] is where they begin, and at last where
    // they end.
    let mut places = vec![0_u32; largest + 2];
    for share in from() {
        for corners in share {
            places[key(corners) + 1] += 1;
        }
    }
    let mut sum = 0;
    for place in &mut places {
        sum += *place;
        *place = sum;
    }
    for share in from() {
        for corners in share {
            let place = &mut places[key(corners)];
            to[*place as usize] = *corners;
            *place += 1;
        }
    }
    places.truncate(largest + 1);
    places
}

/// Sorts the triangles that end at each of `ends`.
fn sort_stars(mut triangles: &mut [[u32; 3]], ends: &[u32]) {
    let mut start = 0;
    for &end in ends {
        let (star, others) = triangles.split_at_mut((end - start) as usize);
        sort_star(star);
        (triangles, start) = (others, end);
    }
}

/// Sorts triangles around one corner: by insertion, as there are seldom more than a handful.
#[inline(always)]
fn sort_star(star: &mut [[u32; 3]]) {
    const HANDFUL: usize = 24;
    if star.len() > HANDFUL {
        star.sort_unstable();
        return;
    }
    for sorted in 1..star.len() {
        let triangle = star[sorted];
        let mut place = sorted;
        while place > 0 && star[place - 1] > triangle {
            star[place] = star[place - 1];
            place -= 1;
        }
        star[place] = triangle;
    }
}
