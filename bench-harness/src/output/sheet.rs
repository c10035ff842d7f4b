//! A table of text, written as Markdown or as CSV.

/// Columns and rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sheet {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Sheet {
    /// A table with these columns and no rows.
    pub(crate) fn new(columns: &[&str]) -> Self {
        Self {
            columns: columns.iter().map(|column| (*column).to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row; cells that are missing stay empty.
    pub(crate) fn push(&mut self, mut row: Vec<String>) {
        row.resize(self.columns.len(), String::new());
        self.rows.push(row);
    }

    /// Whether there are no rows.
    pub(crate) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// As a Markdown table, columns padded so that it reads as plain text too.
    pub(crate) fn markdown(&self) -> String {
        let escape = |text: &String| text.replace('|', "\\|").replace('\n', " ");
        let rows: Vec<Vec<String>> = std::iter::once(&self.columns)
            .chain(&self.rows)
            .map(|row| row.iter().map(escape).collect())
            .collect();
        let width = |column: usize| {
            rows.iter()
                .map(|row| row[column].chars().count())
                .max()
                .unwrap_or(0)
                .max(3)
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let line = |row: &Vec<String>| {
            let cells = row
                .iter()
                .zip(&widths)
                .map(|(cell, width)| format!("{cell:<width$}"));
            format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
        };
        let rule: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
        let mut text = line(&rows[0]) + &line(&rule);
        text.extend(rows[1..].iter().map(line));
        text
    }

    /// As CSV.
    pub(crate) fn csv(&self) -> String {
        let quote = |cell: &String| {
            if cell.contains([',', '"', '\n']) {
                format!("\"{}\"", cell.replace('"', "\"\""))
            } else {
                cell.clone()
            }
        };
        let line = |row: &Vec<String>| row.iter().map(quote).collect::<Vec<_>>().join(",") + "\n";
        std::iter::once(&self.columns)
            .chain(&self.rows)
            .map(line)
            .collect()
    }
}

/// `value` with `digits` decimals, or nothing.
pub(crate) fn fixed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(String::new, |value| format!("{value:.digits$}"))
}

/// Nanoseconds in a unit that suits them, three significant digits.
pub(crate) fn duration(nanoseconds: f64) -> String {
    let (value, unit) = match nanoseconds {
        t if t < 1e3 => (t, "ns"),
        t if t < 1e6 => (t / 1e3, "µs"),
        t if t < 1e9 => (t / 1e6, "ms"),
        t => (t / 1e9, "s"),
    };
    let digits = 2_usize.saturating_sub(value.max(1.0).log10().floor() as usize);
    format!("{value:.digits$} {unit}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms() {
        let mut sheet = Sheet::new(&["a", "b"]);
        sheet.push(vec!["1,5".into(), "x|y".into()]);
        sheet.push(vec!["2".into()]);
        assert_eq!(
            sheet.markdown(),
            "| a   | b    |\n| --- | ---- |\n| 1,5 | x\\|y |\n| 2   |      |\n"
        );
        assert_eq!(sheet.csv(), "a,b\n\"1,5\",x|y\n2,\n");
    }

    #[test]
    fn durations_have_three_digits() {
        assert_eq!(duration(812.4), "812 ns");
        assert_eq!(duration(1_234.0), "1.23 µs");
        assert_eq!(duration(45_600_000.0), "45.6 ms");
        assert_eq!(duration(2e9), "2.00 s");
        assert_eq!(fixed(None, 2), "");
    }
}
