//! Reports from records: Markdown and CSV for every table, SVG and CSV for every figure.

pub(crate) mod claims;
pub(crate) mod first_page;
pub(crate) mod folder;

pub(crate) use crate::output::{plot, sheet};
