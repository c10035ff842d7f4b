//! The conflict graph: which points not yet inserted see which facets.
//!
//! Bipartite. An arc joins a point and a facet in conflict, and lies in two lists: that of the facet, linked one way and
//! in ascending order of the points, and that of the point, linked both ways, so that dropping a facet takes its
//! arcs out of the points' lists in constant time each.
//!
//! ```text
//!                    facet 7          facet 9
//!                      |                |
//!     point 4  <->  (4, 7)  <------>  (4, 9)
//!                      v                v
//!     point 5  <->  (5, 7)              |
//!                                       v
//!     point 8  <--------------------> (8, 9)
//! ```

use geometry_core::mesh::TriangleId;

const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Arc {
    point: u32,
    facet: u32,
    next_of_facet: u32,
    before_of_point: u32,
    next_of_point: u32,
}

/// The first and the last arc of a facet's list.
#[derive(Clone, Copy, Debug)]
struct Ends {
    first: u32,
    last: u32,
}

impl Ends {
    const EMPTY: Ends = Ends {
        first: NONE,
        last: NONE,
    };
}

/// Points are numbered in the order of their insertion.
#[derive(Debug)]
pub(super) struct ConflictGraph {
    arcs: Vec<Arc>,
    free: Vec<u32>,
    /// The list of each facet.
    facets: Vec<Ends>,
    /// The first arc of each point.
    points: Vec<u32>,
}

impl ConflictGraph {
    /// The graph of this many points, without arcs.
    pub(super) fn of_points(count: usize) -> Self {
        Self {
            arcs: Vec::new(),
            free: Vec::new(),
            facets: Vec::new(),
            points: vec![NONE; count],
        }
    }

    /// Adds an arc; `point` comes after all points in conflict with `facet` so far.
    pub(super) fn add(&mut self, facet: TriangleId, point: u32) {
        let slot = facet.0 as usize;
        if slot >= self.facets.len() {
            self.facets.resize(slot + 1, Ends::EMPTY);
        }
        let next_of_point = self.points[point as usize];
        let arc = self.store(Arc {
            point,
            facet: facet.0,
            next_of_facet: NONE,
            before_of_point: NONE,
            next_of_point,
        });
        self.points[point as usize] = arc;
        if next_of_point != NONE {
            self.arcs[next_of_point as usize].before_of_point = arc;
        }
        let Ends { first, last } = self.facets[slot];
        if last != NONE {
            self.arcs[last as usize].next_of_facet = arc;
        }
        self.facets[slot] = Ends {
            first: if first == NONE { arc } else { first },
            last: arc,
        };
    }

    fn store(&mut self, arc: Arc) -> u32 {
        if let Some(free) = self.free.pop() {
            self.arcs[free as usize] = arc;
            return free;
        }
        self.arcs.push(arc);
        self.arcs.len() as u32 - 1
    }

    /// The facets that `point` sees.
    pub(super) fn facets_of(&self, point: u32) -> impl Iterator<Item = TriangleId> + '_ {
        let first = self.points[point as usize];
        self.walk(first, |arc| arc.next_of_point)
            .map(|arc| TriangleId(arc.facet))
    }

    /// The points that see `facet`, ascending.
    pub(super) fn points_of(&self, facet: TriangleId) -> impl Iterator<Item = u32> + '_ {
        let ends = self.facets.get(facet.0 as usize);
        let first = ends.map_or(NONE, |ends| ends.first);
        self.walk(first, |arc| arc.next_of_facet)
            .map(|arc| arc.point)
    }

    fn walk(&self, first: u32, next: fn(&Arc) -> u32) -> impl Iterator<Item = &Arc> + '_ {
        let arc = |at: u32| self.arcs.get(at as usize);
        std::iter::successors(arc(first), move |current| arc(next(current)))
    }

    /// Takes `facet` and its arcs out of the graph.
    pub(super) fn drop_facet(&mut self, facet: TriangleId) {
        let Some(ends) = self.facets.get_mut(facet.0 as usize) else {
            return;
        };
        let mut at = std::mem::replace(ends, Ends::EMPTY).first;
        while at != NONE {
            let arc = self.arcs[at as usize];
            match arc.before_of_point {
                NONE => self.points[arc.point as usize] = arc.next_of_point,
                before => self.arcs[before as usize].next_of_point = arc.next_of_point,
            }
            if arc.next_of_point != NONE {
                self.arcs[arc.next_of_point as usize].before_of_point = arc.before_of_point;
            }
            self.free.push(at);
            at = arc.next_of_facet;
        }
    }

    /// The number of arcs.
    pub(super) fn len(&self) -> usize {
        self.arcs.len() - self.free.len()
    }
}

/// Puts the union of two ascending lists into `union`, ascending.
pub(super) fn unite(
    left: impl Iterator<Item = u32>,
    right: impl Iterator<Item = u32>,
    union: &mut Vec<u32>,
) {
    let (mut left, mut right) = (left.peekable(), right.peekable());
    union.clear();
    loop {
        let next = match (left.peek(), right.peek()) {
            (None, None) => return,
            (Some(&p), None) => p,
            (None, Some(&q)) => q,
            (Some(&p), Some(&q)) => p.min(q),
        };
        left.next_if_eq(&next);
        right.next_if_eq(&next);
        union.push(next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_of_the_graph_agree() {
        let mut graph = ConflictGraph::of_points(6);
        // Point p sees facet f if p is a multiple of f + 1.
        for facet in 0..6 {
            for point in (0..6).filter(|point| point % (facet + 1) == 0) {
                graph.add(TriangleId(facet), point);
            }
        }
        for (dropped, left) in [(0, vec![3, 1]), (3, vec![1]), (1, vec![])] {
            graph.drop_facet(TriangleId(dropped));
            let facets: Vec<u32> = graph.facets_of(4).map(|facet| facet.0).collect();
            assert_eq!(facets, left);
        }
        assert!(graph.points_of(TriangleId(1)).next().is_none());
        assert!(graph.points_of(TriangleId(2)).eq([0, 3]));
        assert_eq!(graph.len(), 2 + 2 + 1);
        graph.add(TriangleId(1), 4);
        assert!(graph.points_of(TriangleId(1)).eq([4]));
    }

    #[test]
    fn a_union_is_ascending_and_without_copies() {
        let mut union = Vec::new();
        unite(
            [1, 3, 5, 9].into_iter(),
            [2, 3, 9, 10].into_iter(),
            &mut union,
        );
        assert_eq!(union, [1, 2, 3, 5, 9, 10]);
    }
}
