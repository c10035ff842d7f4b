//! A drawing and the numbers in it.

use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, Scale, Series, draw};
use crate::reproduce::render::sheet::Sheet;
use anyhow::Result;

/// A chart and its file name.
pub(crate) struct Figure<'a> {
    pub(crate) name: &'a str,
    pub(crate) title: &'a str,
    pub(crate) x: &'a str,
    pub(crate) y: &'a str,
    pub(crate) scale: Scale,
}

impl Figure<'_> {
    /// Writes `name.svg` and `name.csv`.
    pub(crate) fn write(&self, folder: &Folder, series: Vec<Series>) -> Result<()> {
        let filled: Vec<Series> = series
            .into_iter()
            .filter(|series| !series.points.is_empty())
            .collect();
        let chart = Chart {
            title: self.title,
            x: self.x,
            y: self.y,
            scale: self.scale,
            series: &filled,
        };
        if let Some(svg) = draw(&chart)? {
            folder.svg(&format!("{}.svg", self.name), self.title, &svg)?;
        }
        let mut sheet = Sheet::new(&["series", self.x, self.y]);
        for series in &filled {
            for (x, value) in &series.points {
                sheet.push(vec![
                    series.label.clone(),
                    x.to_string(),
                    format!("{value:.4}"),
                ]);
            }
        }
        folder.csv(&format!("{}.csv", self.name), &sheet.csv())
    }
}
