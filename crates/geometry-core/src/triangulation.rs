//! A triangulation of a planar point set, as a canonical value.

/// Up to as many triangles are sorted by comparisons alone.
const FEW: usize = 64;

/// Triangles are sorted by counting if there is one for every so many values of their smallest corners.
const MOST_GAPS: usize = 8;

/// First corners with equal bits above these are sorted together.
const RANGE_BITS: u32 = 12;

/// A triangulation of points of the plane.
///
/// Canonical: each triangle is anticlockwise and begins with its smallest index, and the triangles are in
/// lexicographic order, so two equal triangulations are equal values.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Triangulation {
    triangles: Vec<[u32; 3]>,
}

impl Triangulation {
    /// The triangulation with these anticlockwise triangles, in any order, each starting anywhere.
    ///
    /// # Cost
    ///
    /// Linear where indices are dense and few triangles share a smallest corner, as those of triangulations by any
    /// method are; O(t log t) for t triangles at worst.
    ///
    /// ```
    /// use geometry_core::Triangulation;
    /// let triangulation = Triangulation::new(vec![[2, 3, 0], [1, 2, 0]]);
    /// assert_eq!(triangulation.triangles(), [[0, 1, 2], [0, 2, 3]]);
    /// ```
    pub fn new(mut triangles: Vec<[u32; 3]>) -> Self {
        let mut largest = 0;
        for corners in &mut triangles {
            *corners = smallest_first(*corners);
            largest = largest.max(corners[0]);
        }
        let is_dense = largest as usize / MOST_GAPS <= triangles.len();
        let fits = u32::try_from(triangles.len()).is_ok();
        if triangles.len() > FEW && is_dense && fits {
            sort_by_counting(&mut triangles, largest);
        } else {
            triangles.sort_unstable();
        }
        Self { triangles }
    }

    /// The triangles in canonical order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The number of triangles.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle, as for fewer than three points that are not collinear.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Every edge once, smaller index first, in lexicographic order.
    pub fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges: Vec<[u32; 2]> = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The edges on the convex hull: those of one triangle only, directed anticlockwise, in lexicographic order.
    pub fn hull_edges(&self) -> Vec<[u32; 2]> {
        let directed = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut directed: Vec<[u32; 2]> = directed.collect();
        directed.sort_unstable();
        let is_inner = |&[a, b]: &[u32; 2]| directed.binary_search(&[b, a]).is_ok();
        directed
            .iter()
            .copied()
            .filter(|edge| !is_inner(edge))
            .collect()
    }
}

/// The same triangle from its smallest corner. Short-circuits nothing, as nothing could predict it.
#[inline(always)]
fn smallest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if (b < a) & (b <= c) {
        [b, c, a]
    } else if (c < a) & (c < b) {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

/// Puts triangles into lexicographic order: into ranges by their first corners, within a range into stars with the same
/// first corner, and the few of a star by the others. Two short steps rather than one long one: the places
/// written to at any time stay in the cache.
fn sort_by_counting(triangles: &mut [[u32; 3]], largest: u32) {
    let range = |corners: &[u32; 3]| (corners[0] >> RANGE_BITS) as usize;
    let mut unsorted = vec![[0; 3]; triangles.len()];
    let ends = place_by_key(triangles, &mut unsorted, range(&[largest; 3]), range);
    let star = |corners: &[u32; 3]| corners[0] as usize % (1 << RANGE_BITS);
    let mut start = 0;
    for (range, end) in ends.into_iter().enumerate() {
        let sorted = &mut triangles[start..end as usize];
        let unsorted = &unsorted[start..end as usize];
        let rest = largest as usize - (range << RANGE_BITS);
        let largest_star = rest.min((1 << RANGE_BITS) - 1);
        let ends = place_by_key(unsorted, sorted, largest_star, star);
        sort_stars(sorted, &ends);
        start = end as usize;
    }
}

/// Copies `from` to `to` in the order of their keys, which are at most `largest`. Returns where the triangles of each key
/// end.
#[inline(always)]
fn place_by_key(
    from: &[[u32; 3]],
    to: &mut [[u32; 3]],
    largest: usize,
    key: impl Fn(&[u32; 3]) -> usize,
) -> Vec<u32> {
    // First places[k + 1] is the number of triangles with key k; then places[k] is where they begin, and at last where
    // they end.
    let mut places = vec![0_u32; largest + 2];
    for corners in from {
        places[key(corners) + 1] += 1;
    }
    let mut sum = 0;
    for place in &mut places {
        sum += *place;
        *place = sum;
    }
    for corners in from {
        let place = &mut places[key(corners)];
        to[*place as usize] = *corners;
        *place += 1;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_begins_with_its_smallest_corner_wherever_it_was() {
        for corners in [
            [1, 2, 3],
            [1, 3, 2],
            [2, 1, 3],
            [2, 3, 1],
            [3, 1, 2],
            [3, 2, 1],
        ] {
            let mut expected = corners;
            let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            expected.rotate_left(first);
            assert_eq!(smallest_first(corners), expected, "{corners:?}");
        }
    }

    /// Triangles with every rotation and many equal first corners, by counting and by comparing.
    #[test]
    fn counting_and_comparing_give_the_same_order() {
        for len in [0, 1, FEW, FEW + 1, 40 * FEW] {
            let corner = |i: usize| (i as u32).wrapping_mul(2_654_435_761) >> 20;
            let triangles = (0..len).map(|i| [i, i + len, i + 2 * len].map(corner));
            let canonical = |corners: &[u32; 3]| {
                let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
                [0, 1, 2].map(|i| corners[(first + i) % 3])
            };
            let mut expected: Vec<[u32; 3]> = triangles.clone().map(|t| canonical(&t)).collect();
            expected.sort_unstable();
            let triangulation = Triangulation::new(triangles.collect());
            assert_eq!(triangulation.triangles(), expected);
        }
    }

    #[test]
    fn indices_far_apart_are_sorted_too() {
        let far = u32::MAX - 1;
        let triangles = (0..100).map(|i| [far - i, 7, far - 2 * i]).collect();
        let triangulation = Triangulation::new(triangles);
        assert!(triangulation.triangles().is_sorted());
        assert!(triangulation.triangles().iter().all(|t| t[0] == 7));
    }
}
