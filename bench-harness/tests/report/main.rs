//! The HTML report of made-up runs: whole, self-contained, and opened by a browser without a complaint.

mod browser;
mod content;
#[path = "../analysis/made_up.rs"]
#[allow(dead_code, reason = "the tests of commands write it too")]
mod made_up;
mod markup;
mod material;
