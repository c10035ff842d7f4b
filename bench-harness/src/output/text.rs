//! The pieces of a summary: labelled lines, tables, numbers.

use comfy_table::{ContentArrangement, Table, presets};
use std::fmt::Display;
use std::io::{self, Write};

/// How many vertices a summary shows before it refers to the file.
pub const SHOWN: usize = 10;

/// Writes one labelled line.
///
/// # Errors
///
/// Those of `out`.
pub fn line(out: &mut dyn Write, label: &str, value: impl Display) -> io::Result<()> {
    writeln!(out, "{label:<12} {value}")
}

/// A table without frame, one line a row however wide.
pub fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Disabled)
        .set_header(header.to_vec());
    for column in table.column_iter_mut() {
        column.set_padding((0, 2));
    }
    table
}

/// Writes `table` without the blanks that pad its last column.
///
/// # Errors
///
/// Those of `out`.
pub fn write_table(out: &mut dyn Write, table: &Table) -> io::Result<()> {
    writeln!(out, "{}", table.trim_fmt())
}

/// A number with the fewest digits that read back as the same `f64`, with an exponent if it is long.
pub fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A count with the noun that goes with it.
pub fn count(number: usize, singular: &str, plural: &str) -> String {
    format!("{number} {}", if number == 1 { singular } else { plural })
}
