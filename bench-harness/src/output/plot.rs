//! A line chart against n: series as data, drawn as SVG.

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;

/// The colour-blind safe palette of Okabe and Ito, without its yellow, which is faint on white.
pub const PALETTE: [RGBColor; 7] = [
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
pub const LEGEND: u32 = 150;

/// How a series is drawn, beside its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A solid line with discs.
    Solid,
    /// A dashed line with triangles.
    Dashed,
    /// A thin line without marks: a fit.
    Thin,
}

/// A line of a chart.
#[derive(Clone, Debug)]
pub struct Series {
    /// What the legend calls it; nothing to leave it out there.
    pub label: String,
    /// Its colour.
    pub colour: RGBColor,
    /// How its line is drawn.
    pub stroke: Stroke,
    /// (n, value), by n.
    pub points: Vec<(f64, f64)>,
}

/// How the vertical axis is divided; the horizontal one is always logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// From zero.
    Linear,
    /// By powers of ten.
    Logarithmic,
}

/// A chart.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// Its title.
    pub title: &'a str,
    /// What the horizontal axis is.
    pub x: &'a str,
    /// What the vertical axis is.
    pub y: &'a str,
    /// How the vertical axis is divided.
    pub scale: Scale,
    /// Its lines.
    pub series: &'a [Series],
}

/// What a chart shows beside its lines.
#[derive(Clone, Debug, Default)]
pub struct Marks {
    /// Vertical lines at these n, with what they stand for.
    pub borders: Vec<(f64, String)>,
    /// Horizontal lines at these values.
    pub levels: Vec<f64>,
    /// Intervals: n, the least and the largest value, colour.
    pub intervals: Vec<(f64, f64, f64, RGBColor)>,
}

/// The chart as SVG; `None` if it has no points.
///
/// # Errors
///
/// A fault of the drawing.
pub fn draw(chart: &Chart<'_>) -> Result<Option<String>> {
    draw_marked(chart, &Marks::default())
}

/// The chart with its marks as SVG; `None` if it has no points.
///
/// # Errors
///
/// A fault of the drawing.
pub fn draw_marked(chart: &Chart<'_>, marks: &Marks) -> Result<Option<String>> {
    let mut points: Vec<(f64, f64)> = chart
        .series
        .iter()
        .flat_map(|series| series.points.iter().copied())
        .collect();
    let Some(&(some_n, _)) = points.first() else {
        return Ok(None);
    };
    // Everything that is drawn must lie within the axes.
    points.extend(marks.levels.iter().map(|level| (some_n, *level)));
    let ends = marks.intervals.iter();
    points.extend(ends.flat_map(|&(n, low, high, _)| [(n, low), (n, high)]));
    let most =
        |value: fn(&(f64, f64)) -> f64| points.iter().map(value).fold(f64::NEG_INFINITY, f64::max);
    let least =
        |value: fn(&(f64, f64)) -> f64| points.iter().map(value).fold(f64::INFINITY, f64::min);
    let (left, right) = (least(|p| p.0) * 0.8, most(|p| p.0) * 1.25);
    let x = (left..right).log_scale();
    let top = most(|p| p.1);
    let mut svg = String::new();
    match chart.scale {
        Scale::Linear => {
            let ends = [left, right, 0.0, top * 1.08];
            fill(&mut svg, chart, marks, ends, (x, 0.0..top * 1.08))?;
        }
        Scale::Logarithmic => {
            let ends = [left, right, least(|p| p.1) * 0.8, top * 1.25];
            fill(
                &mut svg,
                chart,
                marks,
                ends,
                (x, (ends[2]..ends[3]).log_scale()),
            )?;
        }
    }
    Ok(Some(svg))
}

/// Wide enough for the longest label, at eight pixels a letter.
fn legend_width(series: &[Series]) -> u32 {
    let letters = series.iter().map(|series| series.label.chars().count());
    let longest = letters.max().unwrap_or(0);
    LEGEND.max(52 + 8 * u32::try_from(longest).unwrap_or(0))
}

/// Draws all of it. The ends are those of the axes: left, right, bottom, top.
fn fill<X, Y>(
    svg: &mut String,
    chart: &Chart<'_>,
    marks: &Marks,
    [left, right, bottom, top]: [f64; 4],
    (x, y): (X, Y),
) -> Result<()>
where
    X: AsRangedCoord<Value = f64>,
    Y: AsRangedCoord<Value = f64>,
    X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let plane = SIZE.0 - LEGEND;
    let size = (plane + legend_width(chart.series), SIZE.1);
    let area = SVGBackend::with_string(svg, size).into_drawing_area();
    area.fill(&WHITE).map_err(drawing)?;
    let (main, side) = area.split_horizontally(plane);
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
    let grey = RGBColor(150, 150, 150);
    let inside = |n: &f64| left < *n && *n < right;
    for (n, label) in marks.borders.iter().filter(|(n, _)| inside(n)) {
        let line = vec![(*n, bottom), (*n, top)];
        let text = Text::new(format!(" {label}"), (*n, top), ("sans-serif", 13));
        context
            .draw_series([PathElement::new(line, grey.stroke_width(1))])
            .map_err(drawing)?;
        context.draw_series([text]).map_err(drawing)?;
    }
    for level in &marks.levels {
        let line = [(left, *level), (right, *level)];
        context
            .draw_series(LineSeries::new(line, grey.stroke_width(1)))
            .map_err(drawing)?;
    }
    for &(n, low, high, colour) in &marks.intervals {
        let line = vec![(n, low), (n, high)];
        context
            .draw_series([PathElement::new(line, colour.stroke_width(2))])
            .map_err(drawing)?;
    }
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
            Stroke::Thin => {
                context
                    .draw_series(LineSeries::new(points, colour.stroke_width(1)))
                    .map_err(drawing)?;
            }
        }
    }
    let named = chart
        .series
        .iter()
        .filter(|series| !series.label.is_empty());
    let entries = named.map(|series| Entry {
        label: series.label.clone(),
        colour: series.colour,
        stroke: series.stroke,
    });
    legend(&side, &entries.collect::<Vec<_>>())?;
    area.present().map_err(drawing)
}

/// The drawing area, in pixels.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A line of a legend.
#[derive(Clone, Debug)]
pub struct Entry {
    /// What it says.
    pub label: String,
    /// The colour of its line.
    pub colour: RGBColor,
    /// How its line is drawn.
    pub stroke: Stroke,
}

/// Draws the legend into an area of its own, so that it hides nothing.
///
/// # Errors
///
/// A fault of the drawing.
pub fn legend(area: &Area<'_>, entries: &[Entry]) -> Result<()> {
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
            Stroke::Thin => {
                let line = vec![(4, y), (36, y)];
                area.draw(&PathElement::new(line, colour.stroke_width(1)))
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
pub fn drawing(error: impl std::fmt::Display) -> anyhow::Error {
    anyhow!("drawing: {error}")
}

/// A tick's label: powers of ten from 10⁵ on as such.
pub fn number(value: f64) -> String {
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
    fn marks_lie_within_the_axes() {
        let series = [Series {
            label: String::new(),
            colour: PALETTE[1],
            stroke: Stroke::Thin,
            points: vec![(100.0, 1.0), (10_000.0, 1.2)],
        }];
        let chart = Chart {
            title: "t",
            x: "points",
            y: "ratio",
            scale: Scale::Logarithmic,
            series: &series,
        };
        let marks = Marks {
            borders: vec![(1_000.0, "L1".into()), (1e9, "L9".into())],
            levels: vec![0.5],
            intervals: vec![(100.0, 0.25, 4.0, PALETTE[1])],
        };
        let svg = draw_marked(&chart, &marks).expect("drawn").expect("points");
        assert!(svg.contains("L1") && !svg.contains("L9"));
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
