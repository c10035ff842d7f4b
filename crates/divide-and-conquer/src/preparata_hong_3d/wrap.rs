//! The wrap: the triangles between two hulls, one after the other.
//!
//! ```text
//!          first half, up
//!
//!                  survives
//!      x ◄──────── a ◄──────── a'         a, b    the bridge: the edge reached
//!       '.        /|\        .'           a', b'  where the ends were before
//!         '.    3/ |2\1    .'  facet      1 2 3   edges of a that were passed: from the one after a'
//!           '.     |     .'    a' b a             clockwise to the one before x
//!             '.   |   .'                 x       the edge of a that turns furthest outwards;
//!               '. | .'                           round b another one, y, anticlockwise
//!     y ◄───────── b
//!                                         the next facet is b a x or b a y, whichever is beyond the other
//!         second half, down
//! ```
//!
//! Round a vertex of a convex polyhedron, and as seen from an edge outside it, the angle rises to one largest value
//! and falls to one smallest. The plane through the bridge only ever turns one way. So a search may start at the edge
//! after the one it arrived by, may stop at the first edge that is no better, and may resume from there after the
//! other end has moved on. No edge that it has passed is looked at again.

use super::edges::{Dart, Half, Note};
use super::questions::{Bridge, Questions};
use super::surface::{Fault, Policy, Scan, Surface, Turn};
use geometry_core::sort::merge_sort;
use geometry_core::{Observer, Point3, Step};
use std::cmp::Ordering;

/// Where the wrap stands.
struct Front {
    /// The ends of the bridge, by half.
    ends: [u32; 2],
    bridge: Bridge,
    /// The edge at each end with the furthest facet found so far; `None` if the half is one point.
    best: [Option<Dart>; 2],
    /// Whether each end has moved yet.
    moved: [bool; 2],
    /// How many more steps are believed.
    budget: usize,
}

impl<P: Policy, Q: Questions, O: Observer> Surface<'_, P, Q, O> {
    /// Finds the facets between the hulls of `count` points that are joined by the bridge `start`.
    ///
    /// Nothing is changed yet: the facets are left in `turns`.
    pub(super) fn wrap(&mut self, start: [u32; 2], count: usize) -> Result<(), Fault> {
        self.turns.clear();
        self.repeats = false;
        let mut front = self.front_at(start, count);
        self.first_edges(&mut front);
        loop {
            for half in Half::BOTH {
                self.best_edge(&mut front, half)?;
            }
            let Some(half) = self.winner(&front) else {
                return Ok(()); // Both halves are points.
            };
            self.turn(&mut front, half);
            if front.ends == start {
                return Ok(());
            }
            front.spend()?;
        }
    }

    /// At the first bridge the facet behind is a vertical one, because the bridge casts the upper supporting line of
    /// the shadows: what is below a is behind, seen from the first facet.
    fn front_at(&mut self, start: [u32; 2], count: usize) -> Front {
        let [a, b] = start.map(|place| self.point(place));
        let length = (b[0] - a[0]).abs() + (b[1] - a[1]).abs();
        let behind: Point3 = [a[0], a[1], a[2] - length];
        let spoke = |place: u32| {
            let place = &self.places[place as usize];
            place.has_edges().then_some(Dart(place.spoke))
        };
        let best = start.map(spoke);
        for place in start {
            self.places[place as usize].wrapped_by = self.merge;
        }
        Front {
            ends: start,
            bridge: Bridge { a, b, behind },
            best,
            moved: [false; 2],
            // Twenty times the facets that the hull of all the points can have.
            budget: 40 * count,
        }
    }

    /// Day's `first_edge`: at the first bridge all edges are looked at, since nothing is known of where to begin.
    fn first_edges(&mut self, front: &mut Front) {
        for half in Half::BOTH {
            if let Some(start) = front.best[half as usize] {
                let best = self.best_of_all(front, half, start);
                front.best[half as usize] = Some(best);
            }
        }
    }

    /// Day's `best_edge`: brings the best edge at one end up to date with the bridge.
    fn best_edge(&mut self, front: &mut Front, half: Half) -> Result<(), Fault> {
        let Some(start) = front.best[half as usize] else {
            return Ok(());
        };
        let best = match P::SCAN {
            Scan::Resumed => self.resume(front, half, start)?,
            Scan::Whole => self.best_of_all(front, half, start),
            Scan::Sorted => self.first_of_sorted(front, half, start),
        };
        if P::SCAN != Scan::Resumed {
            self.note_all_passed(half, start, best);
        }
        front.best[half as usize] = Some(best);
        Ok(())
    }

    /// Steps on from edge to edge while that is an improvement, never beyond an edge by which the wrap arrived: there
    /// another visit begins, or this one did.
    fn resume(&mut self, front: &mut Front, half: Half, start: Dart) -> Result<Dart, Fault> {
        let mut best = start;
        loop {
            let next = self.edges.onward(half, best);
            let arrived = self
                .edges
                .is_noted(self.merge, best.reversed(), Note::Taken);
            if arrived || next == best || !self.is_beyond(front, best, next) {
                return Ok(best);
            }
            // The wrap begins amid a visit, whose first part comes last: it may look at what the second part passed.
            if front.moved[half as usize] {
                self.note_passed(best);
            }
            best = next;
            front.spend()?;
        }
    }

    /// Looks at all edges round the end.
    fn best_of_all(&mut self, front: &Front, half: Half, start: Dart) -> Dart {
        let mut best = start;
        let mut dart = self.edges.onward(half, start);
        while dart != start {
            if self.is_beyond(front, best, dart) {
                best = dart;
            }
            dart = self.edges.onward(half, dart);
        }
        best
    }

    /// Sorts all edges round the end by their angles, largest first.
    fn first_of_sorted(&mut self, front: &Front, half: Half, start: Dart) -> Dart {
        let mut star = vec![start.0];
        let mut dart = self.edges.onward(half, start);
        while dart != start {
            star.push(dart.0);
            dart = self.edges.onward(half, dart);
        }
        let mut scratch = vec![0; star.len()];
        merge_sort(&mut star, &mut scratch, |x, y| {
            if self.is_beyond(front, Dart(x), Dart(y)) {
                Ordering::Greater
            } else {
                Ordering::Less
            }
        });
        Dart(star[0])
    }

    /// Notes for the statistics which edges lie before the best one.
    fn note_all_passed(&mut self, half: Half, start: Dart, best: Dart) {
        let mut dart = start;
        while dart != best {
            self.note_passed(dart);
            dart = self.edges.onward(half, dart);
        }
    }

    fn note_passed(&mut self, dart: Dart) {
        if !self.edges.is_noted(self.merge, dart, Note::Taken) {
            self.edges.note(self.merge, dart, Note::Passed);
        }
    }

    /// Whether the facet on the bridge and `candidate` is beyond the one on the bridge and `best`.
    fn is_beyond(&mut self, front: &Front, best: Dart, candidate: Dart) -> bool {
        self.record.candidates += 1;
        self.record.reexamined +=
            u64::from(self.edges.is_noted(self.merge, candidate, Note::Passed));
        let [x, y] = [best, candidate].map(|dart| self.edges.target(dart));
        let id = self.id(y);
        self.observer.step(|| Step::Candidate(id));
        self.questions
            .is_beyond(&front.bridge, self.point(x), self.point(y))
    }

    /// The half whose best edge is beyond the other's.
    fn winner(&mut self, front: &Front) -> Option<Half> {
        match front.best {
            [None, None] => None,
            [Some(_), None] => Some(Half::First),
            [None, Some(_)] => Some(Half::Second),
            [Some(x), Some(y)] if self.is_beyond(front, x, y) => Some(Half::Second),
            [Some(_), Some(_)] => Some(Half::First),
        }
    }

    /// Makes the facet on the best edge of `half`, and moves the bridge across it.
    fn turn(&mut self, front: &mut Front, half: Half) {
        let Some(dart) = front.best[half as usize] else {
            return;
        };
        self.turns.push(Turn { half, dart });
        self.repeats |= self.edges.is_noted(self.merge, dart, Note::Taken);
        self.edges.note(self.merge, dart, Note::Taken);
        let next = self.edges.target(dart);
        let [a, b, c] = [front.ends[0], front.ends[1], next].map(|place| self.id(place));
        self.observer.step(|| Step::Facet(b, a, c));
        self.places[next as usize].wrapped_by = self.merge;
        front.ends[half as usize] = next;
        front.moved[half as usize] = true;
        front.best[half as usize] = Some(self.edges.onward(half, dart.reversed()));
        let Bridge { a, b, .. } = front.bridge;
        front.bridge = match half {
            Half::First => Bridge {
                a: self.point(next),
                b,
                behind: a,
            },
            Half::Second => Bridge {
                a,
                b: self.point(next),
                behind: b,
            },
        };
    }
}

impl Front {
    fn spend(&mut self) -> Result<(), Fault> {
        self.budget = self.budget.checked_sub(1).ok_or(Fault::Endless)?;
        Ok(())
    }
}
