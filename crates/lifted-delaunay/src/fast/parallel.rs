//! The same triangulation on several threads.
//!
//! The first halvings are those of the sites themselves, each half with its own stretch of the arrays, numbered from zero.
//! Halves are conquered side by side (`rayon::join`); then the second one is renumbered to stand behind the first, and
//! the two are merged as ever. The triangulation is unique, by the rule for ties, so the result does not depend on the threads.
//!
//! The first halvings, their merges and the sorting of the triangles are done by one thread.

use super::asking::Filtered;
use super::halving::{self, Extent};
use super::part::Part;
use super::rings::{HALVES_PER_VERTEX, Half, NONE, Rings, Room};
use super::{Conquest, Site, named, room_for};
use geometry_core::{HullError, Points, Triangulation};
use rayon::prelude::*;

/// Sets of fewer sites are not divided among threads.
const FEW: usize = 10_000;

/// Edges that one thread searches for triangles at a time.
const EDGES: usize = 1 << 16;

/// [`fast_delaunay`](super::fast_delaunay) on the threads of the current rayon pool: the same value.
///
/// # Errors
///
/// As [`fast_delaunay`](super::fast_delaunay).
///
/// # Cost
///
/// As [`fast_delaunay`](super::fast_delaunay), most of it divided by the number of threads.
///
/// ```
/// use geometry_core::Points;
/// let kite = [[0.0, 0.0], [1.0, -1.0], [4.0, 0.0], [1.0, 1.0]];
/// let triangulation = lifted_delaunay::fast_delaunay_parallel(Points::new(&kite)?)?;
/// assert_eq!(triangulation.triangles(), [[0, 1, 3], [1, 2, 3]]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_delaunay_parallel(points: Points<'_, 2>) -> Result<Triangulation, HullError> {
    let (mut sites, mut halves) = room_for(points)?;
    for (site, named) in sites.iter_mut().zip(named(points)) {
        *site = named;
    }
    let forks = rayon::current_num_threads().next_power_of_two().ilog2();
    let (whole, room) = solve(&mut sites, &mut halves, Filtered::new(points), forks);
    let Some(out) = whole.map(|part| part.first[0].out).filter(|&e| e != NONE) else {
        return Ok(Triangulation::default());
    };
    let mut rings = Rings::new(&mut halves, room);
    rings.mark_outside(out);
    let names: Vec<u32> = sites.par_iter().map(|site| site.id).collect();
    let edges = rings.finished();
    let found: Vec<Vec<[u32; 3]>> = (0..edges.len().div_ceil(EDGES))
        .into_par_iter()
        .map(|i| edges.triangles(i * EDGES..edges.len().min((i + 1) * EDGES), &names))
        .collect();
    drop((sites, halves));
    Ok(Triangulation::new(found.concat()))
}

/// The part of all of `sites`, and what room is left among their `halves`, after so many more forks.
fn solve(
    sites: &mut [Site],
    halves: &mut [Half],
    mut filtered: Filtered,
    forks: u32,
) -> (Option<Part>, Room) {
    let room = Room::all(halves);
    let extent = Extent::of(sites.iter().map(|site| site.at));
    if forks == 0 || sites.len() < FEW || extent.is_point() {
        let mut conquest = Conquest {
            sites,
            rings: Rings::new(halves, room),
            asking: &mut filtered,
        };
        let part = conquest.solve(0, conquest.sites.len());
        return (part, conquest.rings.into_room());
    }
    let (first, across) = halving::halve(sites, &extent);
    let (near, far) = sites.split_at_mut(first);
    let base = HALVES_PER_VERTEX * first;
    let (near_halves, far_halves) = halves.split_at_mut(base);
    let ((left, left_room), (right, right_room)) = rayon::join(
        || solve(near, near_halves, filtered, forks - 1),
        || solve(far, far_halves, filtered, forks - 1),
    );
    let mut rings = Rings::new(halves, left_room);
    rings.adopt(base, first as u32, right_room);
    let right = right.map(|part| part.moved(first as u32, base as u32));
    let mut conquest = Conquest {
        sites,
        rings,
        asking: &mut filtered,
    };
    let part = conquest.join(left, right, across);
    (part, conquest.rings.into_room())
}
