//! Figures 1 and 2: the convex hull peels of 100 random points and of an oblique lattice.

use crate::reproduce::green_silverman::definition::RandomData;
use crate::reproduce::green_silverman::studies::layers_method;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{
    Entry, LEGEND, PALETTE, Stroke, drawing, legend, number as tick,
};
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::sets::PointSet2;
use anyhow::{Result, ensure};
use geometry_core::{Boundary, Layers, Points};
use plotters::prelude::*;

const SIDE: u32 = 640;

/// A figure of peels: its file name and what it shows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Figure<'a> {
    pub(crate) name: &'a str,
    pub(crate) title: &'a str,
    pub(crate) data: &'a RandomData,
}

/// Writes the figure's SVG and CSV.
pub(crate) fn write(folder: &Folder, seed: u64, figure: Figure<'_>) -> Result<()> {
    let set = PointSet2::generate(seed, &figure.data.distribution, figure.data.n, 0)?;
    let layers = (layers_method("gs-peel")?.exact)(Points::new(&set.points)?, Boundary::All)?;
    let proof = hull_verify::check::layers(&set.points, Boundary::All, &layers);
    ensure!(
        proof.is_ok(),
        "the peels of {} are not certified",
        figure.name
    );
    let title = format!("{}: {} peels", figure.title, layers.len());
    folder.svg(
        &format!("{}.svg", figure.name),
        &title,
        &draw(&set.points, &layers, &title)?,
    )?;
    let mut sheet = Sheet::new(&["point", "x", "y", "peel"]);
    for (id, (point, stage)) in set.points.iter().zip(layers.c_ranks()).enumerate() {
        sheet.push(vec![
            id.to_string(),
            point[0].to_string(),
            point[1].to_string(),
            stage.to_string(),
        ]);
    }
    let origin = format!(
        "# set: {} n={} seed={} fingerprint={}\n",
        set.distribution,
        set.n,
        set.seed,
        set.fingerprint()
    );
    folder.csv(&format!("{}.csv", figure.name), &(origin + &sheet.csv()))
}

/// A square window, the same scale on both axes.
fn window(points: &[[f64; 2]]) -> [std::ops::Range<f64>; 2] {
    let side = |axis: usize| {
        let values = points.iter().map(|point| point[axis]);
        let least = values.clone().fold(f64::INFINITY, f64::min);
        (least, values.fold(f64::NEG_INFINITY, f64::max))
    };
    let sides = [side(0), side(1)];
    let half = sides
        .iter()
        .map(|(least, most)| most - least)
        .fold(0.0, f64::max)
        * 0.53;
    sides.map(|(least, most)| {
        let middle = least + (most - least) / 2.0;
        middle - half..middle + half
    })
}

fn draw(points: &[[f64; 2]], layers: &Layers, title: &str) -> Result<String> {
    let mut svg = String::new();
    {
        let area =
            SVGBackend::with_string(&mut svg, (SIDE + LEGEND, SIDE + 30)).into_drawing_area();
        let (main, side) = area.split_horizontally(SIDE);
        let mut entries = Vec::new();
        area.fill(&WHITE).map_err(drawing)?;
        let [x, y] = window(points);
        let mut context = ChartBuilder::on(&main)
            .caption(title, ("sans-serif", 18))
            .margin(10)
            .x_label_area_size(36)
            .y_label_area_size(44)
            .build_cartesian_2d(x, y)
            .map_err(drawing)?;
        context
            .configure_mesh()
            .disable_mesh()
            .x_desc("x")
            .y_desc("y")
            .x_label_formatter(&|value| tick(*value))
            .y_label_formatter(&|value| tick(*value))
            .label_style(("sans-serif", 13))
            .draw()
            .map_err(drawing)?;
        for (number, ring) in layers.rings().iter().enumerate() {
            let colour = PALETTE[number % PALETTE.len()];
            let mut outline: Vec<(f64, f64)> = ring
                .vertices()
                .iter()
                .map(|&id| (points[id as usize][0], points[id as usize][1]))
                .collect();
            let corners = outline.clone();
            outline.extend(corners.first().copied());
            entries.push(Entry {
                label: format!("peel {}: {} points", number + 1, corners.len()),
                colour,
                stroke: Stroke::Solid,
            });
            context
                .draw_series(std::iter::once(PathElement::new(
                    outline,
                    colour.stroke_width(2),
                )))
                .map_err(drawing)?;
            context
                .draw_series(
                    corners
                        .into_iter()
                        .map(|corner| Circle::new(corner, 3, BLACK.filled())),
                )
                .map_err(drawing)?;
        }
        legend(&side, &entries)?;
        area.present().map_err(drawing)?;
    }
    Ok(svg)
}
