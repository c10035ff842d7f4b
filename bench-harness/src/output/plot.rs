//! A line chart against n: series as data, drawn as SVG.

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;

/// The colour-blind safe palette of Okabe and Ito, without its yellow, which is faint on white.
pub(crate) const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

const SIZE: (u32, u32) = (900, 540);

/// Width of a legend.
pub(crate) const LEGEND: u32 = 150;

/// How a series is drawn, beside its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stroke {
    /// A solid line with discs.
    Solid,
    /// A dashed line with triangles.
    Dashed,
}

/// A line of a chart.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    pub(crate) label: String,
    pub(crate) colour: RGBColor,
    pub(crate) stroke: Stroke,
    /// (n, value), by n.
    pub(crate) points: Vec<(f64, f64)>,
}

/// How the vertical axis is divided; the horizontal one is always logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scale {
    /// From zero.
    Linear,
    Logarithmic,
}

/// A chart.
#[derive(Clone, Debug)]
pub(crate) struct Chart<'a> {
    pub(crate) title: &'a str,
    pub(crate) x: &'a str,
    pub(crate) y: &'a str,
    pub(crate) scale: Scale,
    pub(crate) series: &'a [Series],
}

/// The chart as SVG; `None` if it has no points.
pub(crate) fn draw(chart: &Chart<'_>) -> Result<Option<String>> {
    let points = || chart.series.iter().flat_map(|series| &series.points);
    if points().next().is_none() {
        return Ok(None);
    }
    let most =
        |value: fn(&(f64, f64)) -> f64| points().map(value).fold(f64::NEG_INFINITY, f64::max);
    let least = |value: fn(&(f64, f64)) -> f64| points().map(value).fold(f64::INFINITY, f64::min);
    let x = (least(|p| p.0) * 0.8..most(|p| p.0) * 1.25).log_scale();
    let top = most(|p| p.1);
    let mut svg = String::new();
    match chart.scale {
        Scale::Linear => fill(&mut svg, chart, x, 0.0..top * 1.08)?,
        Scale::Logarithmic => fill(
            &mut svg,
            chart,
            x,
            (least(|p| p.1) * 0.8..top * 1.25).log_scale(),
        )?,
    }
    Ok(Some(svg))
}

fn fill<X, Y>(svg: &mut String, chart: &Chart<'_>, x: X, y: Y) -> Result<()>
where
    X: AsRangedCoord<Value = f64>,
    Y: AsRangedCoord<Value = f64>,
    X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE).map_err(drawing)?;
    let (main, side) = area.split_horizontally(SIZE.0 - LEGEND);
    let mut context = ChartBuilder::on(&main)
        .caption(chart.title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(46)
        .y_label_area_size(78)
        .build_cartesian_2d(x, y)
        .map_err(drawing)?;
    context
        .configure_mesh()
        .x_desc(chart.x)
        .y_desc(chart.y)
        .x_label_formatter(&|value| number(*value))
        .y_label_formatter(&|value| number(*value))
        .light_line_style(WHITE.mix(0.0))
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 16))
        .draw()
        .map_err(drawing)?;
    for series in chart.series {
        let points = series.points.iter().copied();
        let style = series.colour.stroke_width(2);
        let colour = series.colour;
        match series.stroke {
            Stroke::Solid => {
                context
                    .draw_series(points.clone().map(|p| Circle::new(p, 4, colour.filled())))
                    .map_err(drawing)?;
                context
                    .draw_series(LineSeries::new(points, style))
                    .map_err(drawing)?;
            }
            Stroke::Dashed => {
                context
                    .draw_series(
                        points
                            .clone()
                            .map(|p| TriangleMarker::new(p, 6, colour.filled())),
                    )
                    .map_err(drawing)?;
                context
                    .draw_series(DashedLineSeries::new(points, 8, 5, style))
                    .map_err(drawing)?;
            }
        }
    }
    let entries = chart.series.iter().map(|series| Entry {
        label: series.label.clone(),
        colour: series.colour,
        stroke: series.stroke,
    });
    legend(&side, &entries.collect::<Vec<_>>())?;
    area.present().map_err(drawing)
}

/// The drawing area, in pixels.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A line of a legend.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) label: String,
    pub(crate) colour: RGBColor,
    pub(crate) stroke: Stroke,
}

/// Draws the legend into an area of its own, so that it hides nothing.
pub(crate) fn legend(area: &Area<'_>, entries: &[Entry]) -> Result<()> {
    for (place, entry) in (0..).zip(entries) {
        let y = 50 + 24 * place;
        let colour = entry.colour;
        let piece =
            |from: i32, to: i32| PathElement::new(vec![(from, y), (to, y)], colour.stroke_width(2));
        match entry.stroke {
            Stroke::Solid => {
                area.draw(&piece(4, 36)).map_err(drawing)?;
                area.draw(&Circle::new((20, y), 4, colour.filled()))
                    .map_err(drawing)?;
            }
            Stroke::Dashed => {
                area.draw(&piece(4, 13)).map_err(drawing)?;
                area.draw(&piece(27, 36)).map_err(drawing)?;
                area.draw(&TriangleMarker::new((20, y), 6, colour.filled()))
                    .map_err(drawing)?;
            }
        }
        let text = Text::new(
            entry.label.clone(),
            (44, y - 7),
            ("sans-serif", 14).into_font(),
        );
        area.draw(&text).map_err(drawing)?;
    }
    Ok(())
}

/// What went wrong while drawing. The backend writes to a string, so it is a fault of the chart's.
pub(crate) fn drawing(error: impl std::fmt::Display) -> anyhow::Error {
    anyhow!("drawing: {error}")
}

/// A tick's label: powers of ten from 10⁵ on as such.
pub(crate) fn number(value: f64) -> String {
    let power = value.abs().log10();
    if power >= 5.0 && (power - power.round()).abs() < 1e-9 {
        let digits = (power.round() as i32).to_string();
        let raised = digits
            .chars()
            .filter_map(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10)? as usize));
        return format!("10{}", raised.collect::<String>());
    }
    let rounded = (value * 1e6).round() / 1e6;
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_read_well() {
        assert_eq!(number(1e6), "10⁶");
        assert_eq!(number(1_000.0), "1000");
        assert_eq!(number(0.1 + 0.2), "0.3");
        assert_eq!(number(0.0), "0");
    }

    #[test]
    fn a_chart_names_its_series_and_units() {
        let series = [Series {
            label: "GS, disc".into(),
            colour: PALETTE[0],
            stroke: Stroke::Dashed,
            points: vec![(100.0, 1.0), (1_000.0, 12.0)],
        }];
        for scale in [Scale::Linear, Scale::Logarithmic] {
            let chart = Chart {
                title: "t",
                x: "points",
                y: "ns",
                scale,
                series: &series,
            };
            let svg = draw(&chart).expect("drawn").expect("points");
            assert!(svg.contains("GS, disc") && svg.contains("points") && svg.contains("ns"));
        }
        let empty = Chart {
            title: "t",
            x: "x",
            y: "y",
            scale: Scale::Linear,
            series: &[],
        };
        assert!(draw(&empty).expect("no error").is_none());
    }
}
