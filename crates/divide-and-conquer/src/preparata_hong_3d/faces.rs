//! Listing the facets of the finished hull by Day's spiral.

use super::edges::{Dart, Edges, NONE};
use super::surface::Fault;
use geometry_core::mesh::TriMesh;

/// The facets in the order of a closed path that spirals over the surface (Day, section 4), each as the dart on which
/// the path met it.
///
/// The path has the facets already listed on its right. It begins as one edge there and back, with `start` as its
/// *tail*. A step lists the facet u v w on the left of the tail u → v, and replaces the tail by u → w and w → v:
///
/// ```text
///          w                          w
///                                   ↗   ↘
///   ... ► u ───────► v ► ...  ... ► u     v ► ...       the tail is now w → v
/// ```
///
/// If the path already goes through w, it falls into two: w ... u → w and v ... w → v. Both are followed, the first one
/// first; one that is a single edge there and back encloses nothing. Day follows them by recursion, as deep as there
/// are facets; here those to be followed later wait on a stack.
///
/// `edges` must be those of a triangulated sphere, whose vertices are below `places`; on anything else the path stops
/// with a [`Fault`].
pub(crate) fn by_spiral(edges: &Edges, start: Dart, places: usize) -> Result<Vec<Dart>, Fault> {
    spiral(edges, start, places).map(|spiral| spiral.facets)
}

/// The facets of a spiral, and what following it by recursion would take.
pub(crate) struct Spiral {
    pub(crate) facets: Vec<Dart>,
    /// The most calls of Day's `expand_path_over_faces` within each other.
    pub(crate) deepest: usize,
}

/// [`by_spiral`], with the depth of Day's recursion: a call lists one facet, and what is left of the path, in one
/// piece or two, is a call within it.
pub(crate) fn spiral(edges: &Edges, start: Dart, places: usize) -> Result<Spiral, Fault> {
    let facets = 2 * edges.live() / 3;
    let mut path = Path {
        steps: Vec::with_capacity(facets + 2),
        at: vec![NONE; places],
    };
    let mut listed = Vec::with_capacity(facets);
    let mut waiting = Vec::new();
    let mut tail = path.begin(edges, start);
    let (mut depth, mut deepest) = (0, 0);
    loop {
        if path.encloses_nothing(tail) {
            let Some((next, from)) = waiting.pop() else {
                let facets = listed;
                return Ok(Spiral { facets, deepest });
            };
            (tail, depth) = (next, from);
            path.renew(edges, tail);
            continue;
        }
        if listed.len() == facets {
            return Err(Fault::Tangled);
        }
        let dart = path.steps[tail as usize].dart;
        let [_, to_apex, from_apex] = edges.triangle(dart).ok_or(Fault::Tangled)?;
        listed.push(dart);
        depth += 1;
        deepest = deepest.max(depth);
        let apex = edges.target(to_apex);
        // u → w precedes the tail, which becomes w → v.
        let head = path.insert_before(edges, tail, from_apex.reversed());
        path.steps[tail as usize].dart = to_apex.reversed();
        let contact = path.at[apex as usize];
        if contact == NONE {
            path.renew(edges, tail);
        } else {
            path.split(contact, head, tail);
            waiting.push((tail, depth));
            tail = head;
        }
    }
}

/// A step of the path along one edge: Day's `scan_edge_rec`.
struct PathStep {
    dart: Dart,
    before: u32,
    after: u32,
}

struct Path {
    steps: Vec<PathStep>,
    /// For each place the step that leaves it: Day's `scan_edge_at`.
    at: Vec<u32>,
}

impl Path {
    /// The edge of `dart` there and back; the tail is `dart`.
    fn begin(&mut self, edges: &Edges, dart: Dart) -> u32 {
        for dart in [dart, dart.reversed()] {
            let other = 1 - self.steps.len() as u32;
            self.steps.push(PathStep {
                dart,
                before: other,
                after: other,
            });
            self.renew(edges, self.steps.len() as u32 - 1);
        }
        0
    }

    /// Notes that `step` is the one that leaves its origin.
    fn renew(&mut self, edges: &Edges, step: u32) {
        let origin = edges.origin(self.steps[step as usize].dart);
        self.at[origin as usize] = step;
    }

    fn join(&mut self, step: u32, next: u32) {
        self.steps[step as usize].after = next;
        self.steps[next as usize].before = step;
    }

    fn insert_before(&mut self, edges: &Edges, tail: u32, dart: Dart) -> u32 {
        let before = self.steps[tail as usize].before;
        let head = self.steps.len() as u32;
        self.steps.push(PathStep {
            dart,
            before,
            after: tail,
        });
        self.join(before, head);
        self.join(head, tail);
        self.renew(edges, head);
        head
    }

    /// Cuts the path at the vertex that `contact` leaves and `head` reaches: one part then begins with `contact` and
    /// ends with `head`, the other begins after `tail` and ends with it.
    fn split(&mut self, contact: u32, head: u32, tail: u32) {
        let reaching = self.steps[contact as usize].before;
        self.join(reaching, tail);
        self.join(head, contact);
    }

    /// Whether the path goes along one edge and back. At the very beginning it does too, but then the two sides of
    /// the edge have facets: the path has not moved yet.
    fn encloses_nothing(&self, tail: u32) -> bool {
        let step = &self.steps[tail as usize];
        step.before == step.after && self.steps.len() > 2
    }
}

/// Every facet once, as its smallest dart, in the order of the records: a plain traversal.
pub(crate) fn by_number(edges: &Edges) -> Result<Vec<Dart>, Fault> {
    let mut first = Vec::new();
    for dart in edges.darts() {
        let facet = edges.triangle(dart).ok_or(Fault::Tangled)?;
        if facet.iter().all(|&other| dart <= other) {
            first.push(dart);
        }
    }
    Ok(first)
}

/// The surface of these facets, with the caller's indices of the places.
///
/// A [`Fault`] if an edge has not one facet on either side, or none on both.
pub(crate) fn mesh(edges: &Edges, facets: &[Dart], ids: &[u32]) -> Result<TriMesh, Fault> {
    let mut mesh = TriMesh::default();
    let mut sides = vec![None; 2 * edges.records()];
    for &dart in facets {
        let darts = edges.triangle(dart).ok_or(Fault::Tangled)?;
        let triangle = mesh.add(darts.map(|dart| ids[edges.origin(dart) as usize]));
        for (dart, side) in darts.into_iter().zip(triangle.sides()) {
            if sides[dart.0 as usize].replace(side).is_some() {
                return Err(Fault::Tangled);
            }
        }
    }
    for pair in sides.chunks_exact(2) {
        match pair {
            &[Some(side), Some(twin)] => mesh.link(side, twin),
            [None, None] => {}
            _ => return Err(Fault::Tangled),
        }
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::super::questions::Oriented;
    use super::super::surface::Surface;
    use super::super::{Order, Resumed};
    use super::*;
    use geometry_core::{Exact, Perturbed, Point3, Points, Silent};

    fn smallest(edges: &Edges, dart: Dart) -> Dart {
        let facet = edges.triangle(dart).expect("a triangle");
        facet.into_iter().min().expect("three darts")
    }

    #[test]
    fn the_spiral_meets_every_facet_once() {
        let lattice = |k: usize, count: usize| -> Vec<Point3> {
            let coordinates = |i: usize| [i / k / k, i / k % k, i % k].map(|c| c as f64);
            (0..count).map(coordinates).collect()
        };
        // A double pyramid over a polygon of 100 corners, whose tips have many edges.
        let mut pyramid: Vec<Point3> = (0..100_i32)
            .map(|i| [f64::from(i), f64::from(i * i), f64::from(i % 2)])
            .collect();
        pyramid.extend([[50.0, 4000.0, 1e6], [50.0, 4000.0, -1e6]]);
        for points in [
            lattice(2, 5),
            lattice(2, 8),
            lattice(4, 64),
            lattice(9, 700),
            pyramid,
        ] {
            let order = Order::of(Points::new(&points).expect("finite"), &Exact);
            let questions = Oriented(Perturbed(Exact));
            let mut surface =
                Surface::<Resumed, _, _>::new(&order.points, &order.ids, &questions, Silent);
            surface
                .conquer(0..order.ids.len(), &mut |_| {})
                .expect("an exact kernel");
            let edges = &surface.edges;
            let start = Dart(surface.places[0].spoke);
            let spiral = spiral(edges, start, order.ids.len()).expect("a sphere");
            let facets = spiral.facets.iter();
            let mut listed: Vec<Dart> = facets.map(|&dart| smallest(edges, dart)).collect();
            listed.sort_unstable();
            assert_eq!(listed, by_number(edges).expect("a sphere"));
            assert!(spiral.deepest >= 1 && spiral.deepest <= listed.len());
        }
    }
}
