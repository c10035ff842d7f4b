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

/// Writes `values` after one label, separated by commas, on as many lines as they need.
///
/// # Errors
///
/// Those of `out`.
pub fn list(out: &mut dyn Write, label: &str, values: &[usize]) -> io::Result<()> {
    const WIDTH: usize = 86;
    let mut lines = vec![String::new()];
    for (place, value) in values.iter().enumerate() {
        let comma = if place + 1 < values.len() { "," } else { "" };
        let word = format!("{value}{comma}");
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].len() + 1 + word.len() > WIDTH {
            lines.push(word);
        } else {
            let space = if lines[last].is_empty() { "" } else { " " };
            lines[last] += &format!("{space}{word}");
        }
    }
    line(out, label, &lines[0])?;
    lines[1..].iter().try_for_each(|rest| line(out, "", rest))
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

/// The coordinates of a point in parentheses.
pub fn point(point: &[f64]) -> String {
    let coordinates: Vec<_> = point.iter().map(|&value| number(value)).collect();
    format!("({})", coordinates.join(", "))
}

/// A count with the noun that goes with it.
pub fn count(number: usize, singular: &str, plural: &str) -> String {
    format!("{number} {}", if number == 1 { singular } else { plural })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn listed(values: &[usize]) -> String {
        let mut out = Vec::new();
        list(&mut out, "sizes", values).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_short_list_is_one_line() {
        assert_eq!(listed(&[36, 28, 4]), "sizes        36, 28, 4\n");
        assert_eq!(listed(&[]).trim_end(), "sizes");
    }

    #[test]
    fn a_long_list_wraps_and_loses_nothing() {
        let values: Vec<usize> = (0..200).collect();
        let text = listed(&values);
        assert!(text.lines().all(|line| line.len() < 100), "{text}");
        let back: Vec<usize> = text["sizes".len()..]
            .split(',')
            .map(|value| value.trim().parse().unwrap())
            .collect();
        assert_eq!(back, values);
    }
}
