//! A swept volume as a mesh, CSV, JSON or a summary.
//!
//! The JSON object, schema `hullbench/sweep/1`, holds what that of a hull in space does ([`super::hull3`]) but for the
//! schema under `hull`, and:
//!
//! | member | holds |
//! |---|---|
//! | `schema` | `"hullbench/sweep/1"` |
//! | `by` | the move |
//! | `exact` | whether the hull is the swept volume, or contains it because an end is not representable |
//! | `obstacles` | objects of `x`, `y`, `z` and `location`: `"inside"`, `"boundary"` or `"outside"` |
//! | `hull` | the hull |

use crate::commands::input::Input;
use crate::output::hull3::HullReport3;
use crate::output::rows::write_json;
use crate::output::target::{Format, Report};
use crate::output::text;
use hull_verify::check::Certificate3;
use hullkit::sweep::Sweep;
use hullkit::{Location, Method};
use serde::Serialize;
use std::io::{self, Write};

/// A certified swept volume, ready to be written.
#[derive(Debug, Serialize)]
pub struct SweepReport {
    schema: &'static str,
    by: [f64; 3],
    exact: bool,
    obstacles: Vec<Obstacle>,
    hull: HullReport3,
}

/// An obstacle and where it is.
#[derive(Clone, Debug, Serialize)]
struct Obstacle {
    x: f64,
    y: f64,
    z: f64,
    location: &'static str,
}

impl SweepReport {
    /// The report on `sweep`, whose corners are `swept` and whose hull is proved by `certificate`.
    pub fn new(
        swept: &Input<3>,
        method: &Method,
        sweep: &Sweep,
        certificate: &Certificate3,
        by: [f64; 3],
        located: &[([f64; 3], Location)],
    ) -> Self {
        let obstacle = |&([x, y, z], location): &([f64; 3], Location)| Obstacle {
            x,
            y,
            z,
            location: match location {
                Location::Inside => "inside",
                Location::Boundary => "boundary",
                Location::Outside => "outside",
            },
        };
        Self {
            schema: "hullbench/sweep/1",
            by,
            exact: sweep.is_exact(),
            obstacles: located.iter().map(obstacle).collect(),
            hull: HullReport3::new(swept, method, sweep.hull(), certificate),
        }
    }
}

impl Report for SweepReport {
    const FORMATS: &'static [Format] = HullReport3::FORMATS;

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Json => write_json(out, self),
            _ => self.hull.write(out, format),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        self.hull.write_figures(out)?;
        let exact = if self.exact {
            "the hull is the swept volume"
        } else {
            "an end is not representable; the hull contains the swept volume"
        };
        text::line(out, "rounding", exact)?;
        for obstacle in &self.obstacles {
            let point = text::point(&[obstacle.x, obstacle.y, obstacle.z]);
            text::line(out, "obstacle", format!("{point} {}", obstacle.location))?;
        }
        Ok(())
    }

    fn headline(&self) -> String {
        let met = self.obstacles.iter().filter(|o| o.location != "outside");
        let obstacles = match self.obstacles.len() {
            0 => String::new(),
            all => format!(
                "; {} of {} met",
                met.count(),
                text::count(all, "obstacle", "obstacles")
            ),
        };
        format!("{}{obstacles}", self.hull.headline())
    }

    fn warning(&self, format: Format) -> Option<String> {
        self.hull.warning(format)
    }
}
