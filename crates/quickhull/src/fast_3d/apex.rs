//! The point of a list that is furthest outside a facet.
//!
//! Of those at one height it is the lexicographically largest, which is more often extreme than the others; of its copies the first,
//! because the others are dropped. Copies are in the order of their indices on every list, as they always go together.

use super::lists::{Links, NIL};
use super::plane::Plane;
use geometry_core::{Point3, Points};

/// The point before the furthest of a list, or [`NIL`] if that is the first.
#[inline(always)]
pub(super) fn before_furthest(
    links: &Links,
    first: u32,
    points: Points<'_, 3>,
    plane: &Plane,
) -> u32 {
    let (mut before, mut greatest, mut is_tied) = (NIL, f64::NEG_INFINITY, false);
    let (mut previous, mut id) = (NIL, first);
    while id != NIL {
        let height = plane.height(points[id]);
        is_tied |= height == greatest;
        let is_further = height > greatest;
        greatest = if is_further { height } else { greatest };
        before = if is_further { previous } else { before };
        (previous, id) = (id, links.after(id));
    }
    if is_tied {
        before_largest(links, first, |id| {
            let at = points[id];
            (plane.height(at) == greatest).then_some(at)
        })
    } else {
        before
    }
}

/// The point before the first of the lexicographically largest among those of a list that are `among` the candidates.
#[cold]
#[inline(never)]
fn before_largest(links: &Links, first: u32, among: impl Fn(u32) -> Option<Point3>) -> u32 {
    let (mut before, mut largest) = (NIL, None);
    let mut previous = NIL;
    for id in links.from(first) {
        let at = among(id);
        // No point is less than any.
        if at > largest {
            (before, largest) = (previous, at);
        }
        previous = id;
    }
    before
}

#[cfg(test)]
mod tests {
    use super::super::plane::Span;
    use super::*;

    /// Over the plane z = 0: heights 1, 3, 3, 3, 3, 2, of which the fourth is the largest and has a copy after it.
    #[test]
    fn of_points_as_high_the_first_of_the_largest_is_furthest() {
        let ground = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 9.0, 0.0]];
        let points = [
            [1.0, 1.0, 1.0],
            [1.0, 2.0, 3.0],
            [1.0, 1.0, 3.0],
            [2.0, 0.0, 3.0],
            [2.0, 0.0, 3.0],
            [8.0, 8.0, 2.0],
        ];
        let plane = Plane::through(ground, &Span::of(&[ground, [[9.0; 3]; 3]].concat()));
        let links = Links::of_all(points.len());
        let points = Points::new(&points).expect("finite");
        assert_eq!(before_furthest(&links, 0, points, &plane), 2);
        assert_eq!(before_furthest(&links, 4, points, &plane), NIL);
        assert_eq!(before_furthest(&links, 5, points, &plane), NIL);
    }
}
