//! Figure 1: the Delaunay triangulation of 1,024 flattened, spherically distributed points, certified.

use crate::reproduce::nathan::definition::Studies;
use crate::reproduce::nathan::sets::generate_planar;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{PALETTE, drawing};
use crate::reproduce::render::sheet::Sheet;
use anyhow::{Result, anyhow};
use geometry_core::{Point2, Triangulation};
use plotters::prelude::*;

const SIDE: u32 = 720;

/// Writes `delaunay.svg` and `delaunay.csv`.
pub(crate) fn write(folder: &Folder, studies: &Studies) -> Result<()> {
    let cell = &studies.figure1;
    let points = generate_planar(studies.seed, &cell.distribution, cell.n, 0, 0.0)?;
    let triangulation = hullkit::delaunay(&points)?;
    let certificate = hull_verify::check::delaunay(&points, &triangulation)
        .map_err(|findings| anyhow!("Figure 1 is not certified: {} findings", findings.len()))?;
    let title = format!(
        "{} points, {} triangles, {} edges on the outline",
        certificate.n, certificate.triangles, certificate.hull_edges
    );
    folder.svg(
        "delaunay.svg",
        &title,
        &draw(&points, &triangulation, &title)?,
    )?;
    let mut sheet = Sheet::new(&["a", "b", "c", "ax", "ay", "bx", "by", "cx", "cy"]);
    for corners in triangulation.triangles() {
        let ids = corners.iter().map(ToString::to_string);
        let places = corners.iter().flat_map(|&id| points[id as usize]);
        sheet.push(ids.chain(places.map(|x| x.to_string())).collect());
    }
    let origin = format!(
        "# set: {} n={} fingerprint={}\n",
        cell.distribution,
        cell.n,
        point_sets::fingerprint(&points)
    );
    folder.csv("delaunay.csv", &(origin + &sheet.csv()))
}

fn draw(points: &[Point2], triangulation: &Triangulation, title: &str) -> Result<String> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (SIDE, SIDE + 30)).into_drawing_area();
        area.fill(&WHITE).map_err(drawing)?;
        let reach = points
            .as_flattened()
            .iter()
            .fold(0.0_f64, |most, x| most.max(x.abs()))
            * 1.02;
        let mut context = ChartBuilder::on(&area)
            .caption(title, ("sans-serif", 18))
            .margin(8)
            .build_cartesian_2d(-reach..reach, -reach..reach)
            .map_err(drawing)?;
        let place = |id: u32| (points[id as usize][0], points[id as usize][1]);
        let line = |[a, b]: [u32; 2]| vec![place(a), place(b)];
        let (thin, thick) = (PALETTE[0].stroke_width(1), PALETTE[1].stroke_width(2));
        let edges = triangulation
            .edges()
            .into_iter()
            .map(|edge| PathElement::new(line(edge), thin));
        context.draw_series(edges).map_err(drawing)?;
        let outline = triangulation.hull_edges().into_iter();
        let outline = outline.map(|edge| PathElement::new(line(edge), thick));
        context.draw_series(outline).map_err(drawing)?;
        area.present().map_err(drawing)?;
    }
    Ok(svg)
}
