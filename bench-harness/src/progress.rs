//! How far the run is: a bar on a terminal, else one line a finished cell, both on standard error.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write};

/// The progress of one stage.
#[derive(Debug)]
pub(crate) struct Progress {
    stage: &'static str,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Starts a stage of `cells` cells.
    pub(crate) fn start(stage: &'static str, cells: usize) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar =
                ProgressBar::with_draw_target(Some(cells as u64), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template(
                "{prefix:>9} [{bar:32}] {pos}/{len} {msg} ({eta} left)",
            )
            .unwrap_or_else(|_| ProgressStyle::default_bar());
            bar.set_style(style);
            bar.set_prefix(stage);
            bar
        });
        Self { stage, bar }
    }

    /// Says that `cell` is done.
    pub(crate) fn finished(&self, cell: &str) {
        match &self.bar {
            Some(bar) => {
                bar.set_message(cell.to_owned());
                bar.inc(1);
            }
            None => say(&format!("{}: {cell}", self.stage)),
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// One line on standard error. That nobody reads it is no reason to stop.
pub(crate) fn say(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}
