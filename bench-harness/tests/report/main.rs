//! The HTML report of made-up runs: whole, self-contained, and opened by a browser without a complaint.

mod browser;
mod content;
#[path = "../analysis/made_up.rs"]
mod made_up;
mod markup;
mod material;
