//! A table of text, written as Markdown, as CSV or as LaTeX.

/// Columns and rows.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Sheet {
    /// A table with these columns and no rows.
    pub fn new(columns: &[&str]) -> Self {
        Self {
            columns: columns.iter().map(|column| (*column).to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row; cells that are missing stay empty.
    pub fn push(&mut self, mut row: Vec<String>) {
        row.resize(self.columns.len(), String::new());
        self.rows.push(row);
    }

    /// The names of its columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Its rows, each as long as there are columns.
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// As a Markdown table, columns padded so that it reads as plain text too.
    pub fn markdown(&self) -> String {
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
    pub fn csv(&self) -> String {
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

    /// As a LaTeX table, for the package booktabs: the first column to the left, the others to the right.
    pub fn latex(&self) -> String {
        let line = |row: &Vec<String>| {
            let cells: Vec<String> = row.iter().map(|cell| to_latex(cell)).collect();
            format!("{} \\\\\n", cells.join(" & "))
        };
        let columns = "r".repeat(self.columns.len().saturating_sub(1));
        let mut text = format!("\\begin{{tabular}}{{l{columns}}}\n\\toprule\n");
        text += &line(&self.columns);
        text += "\\midrule\n";
        text.extend(self.rows.iter().map(line));
        text + "\\bottomrule\n\\end{tabular}\n"
    }
}

/// A cell as LaTeX; one that is bold in Markdown is bold here.
fn to_latex(cell: &str) -> String {
    let escape = |text: &str| {
        let mut escaped = String::new();
        for c in text.chars() {
            match c {
                '&' | '%' | '$' | '#' | '_' | '{' | '}' => escaped.extend(['\\', c]),
                '\\' => escaped += "\\textbackslash{}",
                '~' => escaped += "\\textasciitilde{}",
                '^' => escaped += "\\textasciicircum{}",
                '±' => escaped += "$\\pm$",
                'µ' => escaped += "$\\mu$",
                '–' => escaped += "--",
                _ => escaped.push(c),
            }
        }
        escaped
    };
    match cell
        .strip_prefix("**")
        .and_then(|rest| rest.strip_suffix("**"))
    {
        Some(bold) => format!("\\textbf{{{}}}", escape(bold)),
        None => escape(cell),
    }
}

/// `value` with `digits` decimals, or nothing.
pub fn fixed(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(String::new, |value| format!("{value:.digits$}"))
}

/// Nanoseconds in a unit that suits them, three significant digits.
pub fn duration(nanoseconds: f64) -> String {
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
    fn latex_escapes_and_keeps_bold() {
        let mut sheet = Sheet::new(&["n", "gs_2"]);
        sheet.push(vec!["100".into(), "**4.5 µs**".into()]);
        assert_eq!(
            sheet.latex(),
            "\\begin{tabular}{lr}\n\\toprule\nn & gs\\_2 \\\\\n\\midrule\n\
             100 & \\textbf{4.5 $\\mu$s} \\\\\n\\bottomrule\n\\end{tabular}\n"
        );
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
