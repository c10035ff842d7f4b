//! How the ratios move with n.

use crate::analysis::plot::ratios;
use crate::report::document::{Part, Section};
use crate::report::picture::inline;
use crate::report::{Material, command};
use anyhow::Result;

pub(in crate::report) fn section(material: &Material<'_>) -> Result<Option<Section>> {
    let run = material.run;
    let mut parts = vec![Part::text(
        "Each engine's time over that of the engine that is fastest at the largest size, with 95 % intervals. The grey \
         lines are 1 and the ends of the A/A band: between them nothing is claimed.",
    )];
    let drawings = ratios(run)?.into_iter().filter(|drawing| drawing.sizes > 1);
    parts.extend(drawings.map(|drawing| Part::Figure {
        svg: inline(&drawing.svg, &drawing.caption),
        caption: drawing.caption,
    }));
    Ok((parts.len() > 1).then(|| Section {
        id: "ratios".into(),
        heading: "Ratios against n".into(),
        commands: vec![command(run, "plot", "")],
        parts,
    }))
}
