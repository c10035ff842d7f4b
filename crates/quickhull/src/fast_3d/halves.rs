//! The hull of the points left, by halves side by side.
//!
//! The points are halved by a plane, and the halves again, until there is a part for each thread. The hulls of the parts are
//! found as ever, and joined two by two ([`seam`]).

use super::left::Left;
use super::narrowed;
use super::plane::Span;
use super::seam::{self, Shell};
use super::surface::{Surface, surface};
use geometry_core::mesh::TriMesh;
use geometry_core::{Edges, Hull3, HullError, Kernel3, Point3, Points, Silent};
use rayon::prelude::*;

/// How often points are halved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Forks {
    /// At most so many times.
    most: u32,
    /// Fewer points are not.
    least_points: usize,
}

impl Forks {
    /// Until there is a part for each thread of the current pool.
    pub(super) fn for_all_threads() -> Self {
        Self {
            most: rayon::current_num_threads().next_power_of_two().ilog2(),
            least_points: 1 << 13,
        }
    }

    /// Once less; none if `count` points are not to be halved.
    fn taken(self, count: usize) -> Option<Self> {
        let most = self.most.checked_sub(1)?;
        (count >= self.least_points.max(2)).then_some(Self { most, ..self })
    }
}

/// The hull of points that come in parts.
///
/// # Errors
///
/// As [`Points::new`]; [`HullError::Contradiction`] only with a kernel that is not exact.
pub(super) fn hull_by_halves<K: Kernel3 + Sync>(
    parts: Vec<Left>,
    forks: Forks,
    kernel: &K,
) -> Result<Hull3, HullError> {
    let Corners { left, mesh } = corners(parts, forks, kernel)?.in_order();
    let points = Points::new(&left.points)?;
    let hull = match mesh {
        Some((mesh, edges)) => Hull3::from_known_mesh(points, &mesh, edges, kernel),
        None => surface(points, kernel, &mut Silent)?.hull(points, kernel),
    };
    Ok(hull.renumbered(&left.ids))
}

fn corners<K: Kernel3 + Sync>(
    parts: Vec<Left>,
    forks: Forks,
    kernel: &K,
) -> Result<Corners, HullError> {
    let count = parts.iter().map(|part| part.points.len()).sum();
    let Some(forks) = forks.taken(count) else {
        let left = narrowed(Left::joined(parts), kernel, &mut Silent)?;
        return Corners::of(left, kernel);
    };
    let cut = Cut::of(&parts, count);
    let divided = parts.into_par_iter().map(|part| cut.divide(part));
    let (near, far): (Vec<Left>, Vec<Left>) = divided.unzip();
    let (near, far) = rayon::join(
        || corners(near, forks, kernel),
        || corners(far, forks, kernel),
    );
    Corners::joined(near?, far?, kernel)
}

/// A plane across an axis.
struct Cut {
    axis: usize,
    at: f64,
}

impl Cut {
    /// So many points decide where it is: chance puts one in a hundred on the wrong side.
    const SAMPLE: usize = 4096;

    /// One across the longest extent of the points, of which there are `count`, that has about half of them on either side. It may
    /// have none on one side.
    fn of(parts: &[Left], count: usize) -> Self {
        let all = parts.iter().flat_map(|part| &part.points);
        let every = count / Self::SAMPLE + 1;
        let sample: Vec<Point3> = all.step_by(every).copied().collect();
        let axis = Span::of(&sample).widest_axis();
        let mut coordinates: Vec<f64> = sample.iter().map(|p| p[axis]).collect();
        let middle = coordinates.len() / 2;
        let at = *coordinates.select_nth_unstable_by(middle, f64::total_cmp).1;
        Self { axis, at }
    }

    /// Copies stay together, as do points of which the coordinate is not a number.
    fn divide(&self, left: Left) -> (Left, Left) {
        let mut halves = [Left::default(), Left::default()];
        for (point, id) in left.points.into_iter().zip(left.ids) {
            let half = &mut halves[usize::from(point[self.axis] >= self.at)];
            half.points.push(point);
            half.ids.push(id);
        }
        halves.into()
    }
}

/// The points of a set that may be extreme, and the surface of its hull with what is known of its edges.
struct Corners {
    left: Left,
    /// A set that does not span space has none.
    mesh: Option<(TriMesh, Edges)>,
}

impl Corners {
    /// Those of `left`.
    fn of<K: Kernel3>(left: Left, kernel: &K) -> Result<Self, HullError> {
        let points = Points::new(&left.points)?;
        Ok(match surface(points, kernel, &mut Silent)? {
            Surface::Solid(mesh, edges) => Self {
                left,
                mesh: Some((mesh, edges)),
            }
            .in_order(),
            Surface::Flat(hull) => Self {
                left: left.picked(hull.vertices()),
                mesh: None,
            },
        })
    }

    /// Those of two sets that a plane separates.
    fn joined<K: Kernel3 + Sync>(near: Self, far: Self, kernel: &K) -> Result<Self, HullError> {
        let all = near.left.and(&far.left);
        let first = near.left.ids.len() as u32;
        if let (Some(near), Some(far)) = (near.shell(0), far.shell(first))
            && let Some(mesh) = seam::joined([near, far], &all, kernel)?
        {
            return Ok(Self {
                left: all,
                mesh: Some(mesh),
            });
        }
        Self::of(all, kernel)
    }

    /// The surface, of points that begin at `first` among those of two sets.
    fn shell(&self, first: u32) -> Option<Shell<'_>> {
        let (mesh, edges) = self.mesh.as_ref()?;
        Some(Shell {
            left: &self.left,
            mesh,
            edges: *edges,
            first,
        })
    }

    /// The same without points that are no corners, in the caller's order.
    fn in_order(mut self) -> Self {
        let count = self.left.ids.len();
        let mut is_corner = vec![self.mesh.is_none(); count];
        if let Some((mesh, _)) = &self.mesh {
            let corners = mesh.triangles().flat_map(|t| mesh.corners(t));
            corners.for_each(|corner| is_corner[corner as usize] = true);
        }
        let places = 0..count as u32;
        let mut places: Vec<u32> = places.filter(|&place| is_corner[place as usize]).collect();
        places.sort_unstable_by_key(|&place| self.left.ids[place as usize]);
        if let Some((mesh, _)) = &mut self.mesh {
            let mut ranks = vec![0; count];
            for (rank, &place) in (0..).zip(&places) {
                ranks[place as usize] = rank;
            }
            mesh.renumber(|place| ranks[place as usize]);
        }
        self.left = self.left.picked(&places);
        self
    }
}

#[cfg(test)]
mod tests;
