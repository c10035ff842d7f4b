//! Whether triangles cut up the facets of a proved hull.
//!
//! Most programs give a spatial hull as triangles and leave coplanar ones unmerged. Such a claim needs no arithmetic once
//! the hull itself is proved:
//!
//! 1. Every triangle has its corners in one facet, in the cyclic order of the facet. Facets are strictly convex, so it
//!    lies in the facet and faces outwards.
//! 2. No edge occurs twice in the same direction, and every edge occurs in the other direction too.
//!
//! An edge that is a diagonal of a facet can only be an edge of triangles of that facet. So by 2 the triangles of one
//! facet have a boundary made of edges of the facet, each at most once; facing one way, they cover the facet once or
//! there are none of them. If there were none, an edge of a neighbour would have no other direction. So every facet is
//! covered once.

use geometry_core::Hull3;

/// Checks that `triangles` cut up the facets of `hull`, a hull that is proved.
///
/// # Errors
///
/// What is wrong, in words.
///
/// # Cost
///
/// O(m log m) for m corners in all, unless many triangles have three corners of high degree.
///
/// ```
/// use bench_harness::engine::cut::cuts_up;
/// let cube: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let hull = hullkit::convex_hull_3d(&cube)?;
/// let mut triangles: Vec<[u32; 3]> = hull.triangles().collect();
/// assert_eq!(cuts_up(&triangles, &hull), Ok(()));
/// triangles.pop();
/// assert!(cuts_up(&triangles, &hull).is_err());
/// # Ok::<(), hullkit::HullError>(())
/// ```
pub fn cuts_up(triangles: &[[u32; 3]], hull: &Hull3) -> Result<(), String> {
    let facets = Facets::of(hull);
    for &triangle in triangles {
        facets.find(triangle)?;
    }
    let around = |&[a, b, c]: &[u32; 3]| [(a, b), (b, c), (c, a)];
    let mut edges: Vec<(u32, u32)> = triangles.iter().flat_map(around).collect();
    edges.sort_unstable();
    if let Some(twice) = edges.windows(2).find(|pair| pair[0] == pair[1]) {
        let (a, b) = twice[0];
        return Err(format!("two triangles have the edge from {a} to {b}"));
    }
    let mut back: Vec<(u32, u32)> = edges.iter().map(|&(a, b)| (b, a)).collect();
    back.sort_unstable();
    match edges.iter().zip(&back).find(|(edge, back)| edge != back) {
        // The smaller of the two has no partner in the other list.
        Some((edge, back)) => {
            let (a, b) = edge.min(back);
            Err(format!(
                "one triangle only has the edge between {a} and {b}"
            ))
        }
        None if triangles.is_empty() && hull.dimension() == Some(3) => Err("no triangles".into()),
        None => Ok(()),
    }
}

/// Where each vertex is on which facets.
struct Facets {
    /// Where the places of each point begin in `places`, and at the end where they end.
    starts: Vec<u32>,
    /// For each vertex the facets it is on, ascending, and its place there.
    places: Vec<(usize, usize)>,
}

impl Facets {
    fn of(hull: &Hull3) -> Self {
        let points = hull
            .vertices()
            .iter()
            .max()
            .map_or(0, |&id| id as usize + 1);
        let mut starts = vec![0; points + 1];
        for &corner in hull.facets().flatten() {
            starts[corner as usize + 1] += 1;
        }
        for point in 0..points {
            starts[point + 1] += starts[point];
        }
        let mut next = starts.clone();
        let mut places = vec![(0, 0); starts[points] as usize];
        for (facet, corners) in hull.facets().enumerate() {
            for (place, &corner) in corners.iter().enumerate() {
                let next = &mut next[corner as usize];
                places[*next as usize] = (facet, place);
                *next += 1;
            }
        }
        Self { starts, places }
    }

    /// The facets that the point `id` is on, and its place there; none if it is no vertex.
    fn of_point(&self, id: u32) -> &[(usize, usize)] {
        let start = self.starts.get(id as usize);
        let end = self.starts.get(id as usize + 1);
        match (start, end) {
            (Some(&start), Some(&end)) => &self.places[start as usize..end as usize],
            _ => &[],
        }
    }

    /// Finds the facet that `triangle` is on, facing the same way.
    fn find(&self, triangle: [u32; 3]) -> Result<usize, String> {
        let mut corners = [(0, &[][..]); 3];
        for (corner, id) in corners.iter_mut().zip(triangle) {
            *corner = (id, self.of_point(id));
            if corner.1.is_empty() {
                return Err(format!("corner {id} is no vertex of the hull"));
            }
        }
        // Fewest facets first.
        let first = (0..3).min_by_key(|&i| corners[i].1.len()).unwrap_or(0);
        corners.rotate_left(first);
        let [(_, of_a), (_, of_b), (_, of_c)] = corners;
        let place_on = |places: &[(usize, usize)], facet| {
            let found = places.binary_search_by_key(&facet, |(facet, _)| *facet);
            found.ok().map(|index| places[index].1)
        };
        let faces_out =
            |(facet, a): &&(usize, usize)| match (place_on(of_b, *facet), place_on(of_c, *facet)) {
                // In cyclic order two of three steps go up; otherwise one.
                (Some(b), Some(c)) => [*a < b, b < c, c < *a].iter().filter(|up| **up).count() == 2,
                _ => false,
            };
        let facet = of_a.iter().find(faces_out);
        facet.map(|(facet, _)| *facet).ok_or_else(|| {
            let [a, b, c] = triangle;
            format!("triangle {a} {b} {c} is on no facet of the hull")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube, its facets cut from their first corners.
    fn cube() -> (Hull3, Vec<[u32; 3]>) {
        let corner = |i: u32| [i & 1, i >> 1 & 1, i >> 2].map(f64::from);
        let points: Vec<[f64; 3]> = (0..8).map(corner).chain([[0.5, 0.5, 0.0]]).collect();
        let hull = hullkit::convex_hull_3d(&points).unwrap();
        let triangles = hull.triangles().collect();
        (hull, triangles)
    }

    #[track_caller]
    fn assert_flaw(change: impl FnOnce(&mut Vec<[u32; 3]>), flaw: &str) {
        let (hull, mut triangles) = cube();
        change(&mut triangles);
        let found = cuts_up(&triangles, &hull).unwrap_err();
        assert!(found.contains(flaw), "{found}");
    }

    #[test]
    fn any_way_to_cut_is_right() {
        let (hull, mut triangles) = cube();
        assert_eq!(cuts_up(&triangles, &hull), Ok(()));
        // The other diagonal of the first facet.
        let facet: Vec<u32> = hull.facets().next().unwrap().to_vec();
        triangles.splice(
            0..2,
            [
                [facet[0], facet[1], facet[3]],
                [facet[1], facet[2], facet[3]],
            ],
        );
        triangles[5].rotate_left(1);
        assert_eq!(cuts_up(&triangles, &hull), Ok(()));
    }

    #[test]
    fn flaws_are_found() {
        assert_flaw(|t| t[3].swap(0, 1), "on no facet");
        assert_flaw(|t| t.truncate(11), "one triangle only");
        assert_flaw(|t| t.push(t[0]), "two triangles");
        assert_flaw(|t| t[0][0] = 8, "no vertex");
        assert_flaw(|t| t[0] = [0, 3, 7], "on no facet");
        assert_flaw(Vec::clear, "no triangles");
    }

    #[test]
    fn a_facet_that_is_not_covered_is_found() {
        let (hull, triangles) = cube();
        let facet: Vec<u32> = hull.facets().next().unwrap().to_vec();
        let elsewhere = |t: &&[u32; 3]| !t.iter().all(|corner| facet.contains(corner));
        let triangles: Vec<[u32; 3]> = triangles.iter().filter(elsewhere).copied().collect();
        assert_eq!(triangles.len(), 10);
        assert!(cuts_up(&triangles, &hull).is_err());
    }
}
