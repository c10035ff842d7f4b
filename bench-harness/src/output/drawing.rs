//! A triangulation as an SVG drawing.

use geometry_core::Triangulation;
use std::collections::BTreeSet;
use std::io::{self, Write};

/// The longer side of the drawing, and the margin round it.
const SIDE: f64 = 900.0;
const MARGIN: f64 = 20.0;

/// Points beyond this many are not drawn as dots.
const DOTS: usize = 20_000;

/// Draws the points and the edges, those of the hull stronger.
///
/// # Errors
///
/// Those of `out`.
pub fn write(
    out: &mut dyn Write,
    points: &[[f64; 2]],
    triangulation: &Triangulation,
) -> io::Result<()> {
    let view = View::of(points);
    let [width, height] = view.size;
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.2} {height:.2}\">"
    )?;
    writeln!(out, "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>")?;
    let hull: BTreeSet<[u32; 2]> = triangulation
        .hull_edges()
        .into_iter()
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    let (outer, inner): (Vec<_>, Vec<_>) = triangulation
        .edges()
        .into_iter()
        .partition(|edge| hull.contains(edge));
    for (edges, style) in [
        (inner, "stroke=\"#6b8fb5\" stroke-width=\"0.7\""),
        (outer, "stroke=\"#1f3b5c\" stroke-width=\"1.6\""),
    ] {
        write!(
            out,
            "<path fill=\"none\" stroke-linecap=\"round\" {style} d=\""
        )?;
        for edge in edges {
            let [[x0, y0], [x1, y1]] = edge.map(|id| view.place(points[id as usize]));
            write!(out, "M{x0:.2} {y0:.2}L{x1:.2} {y1:.2}")?;
        }
        writeln!(out, "\"/>")?;
    }
    if points.len() <= DOTS {
        writeln!(out, "<g fill=\"#b5482f\">")?;
        for point in points {
            let [x, y] = view.place(*point);
            writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"1.6\"/>")?;
        }
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}

/// Where points are on the paper: one scale for both axes, y upwards.
struct View {
    low: [f64; 2],
    /// The longer side of the box round the points, halved so that it does not overflow.
    half: f64,
    size: [f64; 2],
}

impl View {
    fn of(points: &[[f64; 2]]) -> Self {
        let bound = |axis: usize, better: fn(f64, f64) -> f64| {
            let coordinates = points.iter().map(|point| point[axis]);
            coordinates.reduce(better).unwrap_or(0.0)
        };
        let low = [0, 1].map(|axis| bound(axis, f64::min));
        let halves = [0, 1].map(|axis| bound(axis, f64::max) / 2.0 - low[axis] / 2.0);
        let longer = halves[0].max(halves[1]);
        let half = if longer > 0.0 { longer } else { 1.0 };
        let size = halves.map(|side| side / half * SIDE + 2.0 * MARGIN);
        Self { low, half, size }
    }

    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|axis| {
            let along = (point[axis] / 2.0 - self.low[axis] / 2.0) / self.half;
            MARGIN + along * SIDE
        });
        [x, self.size[1] - y]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_any_size_are_on_the_paper() {
        for points in [
            vec![],
            vec![[1.0, 1.0]],
            vec![[f64::MIN, f64::MIN], [f64::MAX, 0.0]],
            vec![[5e-324, 0.0], [0.0, 1e-323]],
        ] {
            let view = View::of(&points);
            for point in points {
                let [x, y] = view.place(point);
                assert!((MARGIN..=view.size[0] - MARGIN).contains(&x), "{x}");
                assert!((MARGIN..=view.size[1] - MARGIN).contains(&y), "{y}");
            }
        }
    }
}
