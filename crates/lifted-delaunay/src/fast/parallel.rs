//! The same triangulation on several threads.
//!
//! The first halvings are those of the sites themselves, each half with its own stretch of the arrays, numbered from zero.
//! Halves are conquered side by side (`rayon::join`); then the second one is renumbered to stand behind the first, and
//! the two are merged as ever. The triangulation is unique, by the rule for ties, so the result does not depend on the threads.
//!
//! The first halvings and their merges are done by one thread.

use super::asking::Filtered;
use super::faces::{Faces, TRIPLES_PER_VERTEX, Triple};
use super::halving::{self, Extent};
use super::part::Part;
use super::site::{Site, Sited, room_for_triangles};
use super::{Conquest, room_for_faces};
use geometry_core::triangulation::order::{Dealt, Keys};
use geometry_core::{HullError, Points, Triangulation};
use rayon::prelude::*;

/// Sets of fewer sites are not divided among threads.
const FEW: usize = 10_000;

/// The faces are searched for triangles, and these are sorted, in so many shares a thread.
const SHARES: usize = 4;

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
    let mut triples = room_for_faces(points)?;
    let places = points.as_slice().par_iter().zip(0..points.len() as u32);
    let mut sites: Vec<Site> = places.map(|(&at, id)| Site::new(at, id)).collect();
    let forks = rayon::current_num_threads().next_power_of_two().ilog2();
    solve(&mut sites, &mut triples, Filtered::new(points), forks);
    let names: Vec<u32> = sites.par_iter().map(Sited::id).collect();
    let faces = Faces::new(&mut triples);
    let share = faces.len().div_ceil(SHARES * rayon::current_num_threads()) + 1;
    let triangles = room_for_triangles(&mut sites);
    let shares = triangles.par_chunks_mut(share).enumerate();
    let found: Vec<usize> = shares
        .map(|(i, room)| {
            let places = i * share..i * share + room.len();
            faces.triangles(places, &names, room)
        })
        .collect();
    Ok(in_order(triangles, share, &found, triples))
}

/// The triangulation with the first `found[i]` triangles of each share of so many places, sorted in `room`, which is twice as
/// long.
fn in_order(
    triangles: &[Triple],
    share: usize,
    found: &[usize],
    mut room: Vec<Triple>,
) -> Triangulation {
    let all = || triangles.par_chunks(share).zip(found);
    let largest_of =
        |(part, &found): (&[Triple], &usize)| part[..found].iter().map(|corners| corners[0]).max();
    let largest = all().filter_map(largest_of).max().unwrap_or(0);
    let count = found.iter().sum();
    let Some(keys) = Keys::up_to(largest, count) else {
        let parts: Vec<_> = all().map(|(part, &found)| &part[..found]).collect();
        return Triangulation::new(parts.concat());
    };
    let (sorted, others) = room.split_at_mut(triangles.len());
    let dealt: Vec<Dealt> = all()
        .zip(others.par_chunks_mut(share))
        .map(|((part, &found), room)| Dealt::of(&part[..found], keys, &mut room[..found]))
        .collect();
    keys.ranges_of(&dealt, &mut sorted[..count])
        .into_par_iter()
        .for_each(|(range, sorted)| keys.sort_range(range, &dealt, sorted));
    room.truncate(count);
    room.shrink_to_fit();
    Triangulation::from_canonical(room)
}

/// The part of all of `sites`, after so many more forks.
fn solve(
    sites: &mut [Site],
    triples: &mut [Triple],
    mut filtered: Filtered,
    forks: u32,
) -> Option<Part> {
    let extent = Extent::of(sites.iter().map(Sited::at));
    if forks == 0 || sites.len() < FEW || extent.is_point() {
        let mut conquest = Conquest {
            sites,
            faces: Faces::new(triples),
            asking: &mut filtered,
        };
        return conquest.solve(0, conquest.sites.len());
    }
    let (first, across) = halving::halve(sites, &extent);
    let (near, far) = sites.split_at_mut(first);
    let (near_triples, far_triples) = triples.split_at_mut(TRIPLES_PER_VERTEX * first);
    let (left, right) = rayon::join(
        || solve(near, near_triples, filtered, forks - 1),
        || solve(far, far_triples, filtered, forks - 1),
    );
    let mut faces = Faces::new(triples);
    faces.adopt(first);
    let right = right.map(|part| part.moved(first as u32));
    let mut conquest = Conquest {
        sites,
        faces,
        asking: &mut filtered,
    };
    conquest.join(left, right, first, across)
}
