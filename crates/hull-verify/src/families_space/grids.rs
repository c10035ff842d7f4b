//! Lattices and polyhedra with many points on their facets and edges.

use geometry_core::Point3;

/// All (i, j, l) for i, j, l in 0..k.
pub fn lattice(k: u32) -> Vec<Point3> {
    (0..k * k * k)
        .map(|cell| [cell % k, cell / k % k, cell / (k * k)].map(f64::from))
        .collect()
}

/// The lattice of tenths: lines along the axes are straight, diagonals not all.
pub fn lattice_of_tenths(k: u32) -> Vec<Point3> {
    lattice(k).into_iter().map(|p| p.map(|x| 0.1 * x)).collect()
}

/// The lattice sheared so that no facet is along an axis.
pub fn sheared_lattice(k: u32) -> Vec<Point3> {
    lattice(k)
        .into_iter()
        .map(|[x, y, z]| [x + 2.0 * y - z, 3.0 * x - y + z, x + y + 4.0 * z])
        .collect()
}

/// The lattice points on the surface of a cube of side `k`, and none inside.
pub fn cube_surface(k: u32) -> Vec<Point3> {
    let top = f64::from(k);
    let on_surface = |p: &Point3| p.iter().any(|&x| x == 0.0 || x == top);
    lattice(k + 1).into_iter().filter(on_surface).collect()
}

/// The eight corners of a cube, with its centre first.
pub fn cube() -> Vec<Point3> {
    let mut points = vec![[1.0; 3]];
    points.extend(lattice(2).into_iter().map(|p| p.map(|x| 2.0 * x)));
    points
}

/// A box of 1 × 2 × 3 on its corner.
pub fn tilted_box() -> Vec<Point3> {
    lattice(2)
        .into_iter()
        .map(|[a, b, c]| {
            // Along (2, 1, 2), 2 (1, 2, -2), 3 (-2, 2, 1), which are perpendicular.
            [
                2.0 * a + 2.0 * b - 6.0 * c,
                a + 4.0 * b + 6.0 * c,
                2.0 * a - 4.0 * b + 3.0 * c,
            ]
        })
        .collect()
}

/// All (i, j, l) with |i| + |j| + |l| ≤ r: an octahedron, its eight facets full of points.
pub fn octahedron(r: i32) -> Vec<Point3> {
    let mut points = Vec::new();
    for x in -r..=r {
        for y in -r..=r {
            for z in -r..=r {
                if x.abs() + y.abs() + z.abs() <= r {
                    points.push([x, y, z].map(f64::from));
                }
            }
        }
    }
    points
}

/// The octahedron's corners and the middles of its edges, those first.
pub fn octahedron_with_midpoints() -> Vec<Point3> {
    let mut points: Vec<Point3> = octahedron(2)
        .into_iter()
        .filter(|p| p.iter().map(|x| x.abs()).sum::<f64>() == 2.0)
        .collect();
    points.sort_by_key(|p| p.iter().filter(|&&x| x == 0.0).count());
    points
}

/// `n` points along each of the three axes, both ways, and the origin.
pub fn jack(n: i32) -> Vec<Point3> {
    let mut points = Vec::new();
    for t in -n..=n {
        let t = f64::from(t);
        points.extend([[t, 0.0, 0.0], [0.0, t, 0.0], [0.0, 0.0, t]]);
    }
    points
}

/// Columns of `n` points upright over a 2 × 2 square: every facet but two is vertical and full of points.
pub fn four_columns(n: u32) -> Vec<Point3> {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let column = |[x, y]: [f64; 2]| (0..n).map(move |i| [x, y, f64::from(i)]);
    corners.into_iter().flat_map(column).collect()
}
