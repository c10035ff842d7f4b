//! The verdicts on the papers, and their tables beside ours, from the folders that `hullbench reproduce` writes.

use super::document::{Entry, Table};
use crate::failure::Failure;
use std::fs;
use std::path::{Path, PathBuf};

/// A reproduced paper.
#[derive(Clone, Debug)]
pub struct Paper {
    /// Who wrote it, and when.
    pub title: String,
    /// Where its report lies.
    pub report: PathBuf,
    /// The claims with their verdicts.
    pub verdicts: Vec<Table>,
    /// Every part of every claim, with the statistic that decides.
    pub parts: Table,
    /// Its other tables, file by file.
    pub tables: Vec<(String, Vec<Table>)>,
}

/// The file that says a folder is that of a paper.
const CLAIMS: &str = "claims.csv";

/// The page of a paper.
const REPORT: &str = "REPORT.md";

/// Pages that are shown otherwise.
const SHOWN: [&str; 2] = [REPORT, "claims.md"];

/// The papers below `folder`, by the names of their folders.
///
/// # Errors
///
/// [`Failure::Io`]; [`Failure::Data`] if `folder` has no report of a paper, or its claims are no CSV.
pub fn read(folder: &Path) -> Result<Vec<Paper>, Failure> {
    let with_claims = |path: &PathBuf| path.join(CLAIMS).is_file();
    let folders: Vec<PathBuf> = files(folder)?.into_iter().filter(with_claims).collect();
    if folders.is_empty() {
        return Err(Failure::Data(format!(
            "{}: no folder in it has a {CLAIMS}; give the folder that `hullbench reproduce` writes",
            folder.display()
        )));
    }
    folders.iter().map(|folder| paper(folder)).collect()
}

fn paper(folder: &Path) -> Result<Paper, Failure> {
    let report = folder.join(REPORT);
    let page = text(&report)?;
    let title = page.lines().find_map(|line| line.strip_prefix("# "));
    let mut pages = files(folder)?;
    pages.retain(|path| {
        let name = path.file_name().unwrap_or_default();
        path.extension().is_some_and(|extension| extension == "md")
            && SHOWN.iter().all(|shown| name != *shown)
    });
    let mut found = Vec::new();
    for path in pages {
        let page = text(&path)?;
        let title = page.lines().find_map(|line| line.strip_prefix("# "));
        let tables = tables(&page);
        if let (Some(title), false) = (title, tables.is_empty()) {
            found.push((title.to_owned(), tables));
        }
    }
    let mut verdicts = tables(&page);
    verdicts.retain(|table| table.caption == "Verdicts");
    Ok(Paper {
        title: title.unwrap_or_default().replace(", reproduced", ""),
        verdicts,
        parts: claims(&folder.join(CLAIMS))?,
        tables: found,
        report,
    })
}

fn claims(path: &Path) -> Result<Table, Failure> {
    let text = text(path)?;
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .flexible(true)
        .from_reader(text.as_bytes());
    let fail = |error: csv::Error| Failure::Data(format!("{}: {error}", path.display()));
    let columns: Vec<String> = reader
        .headers()
        .map_err(fail)?
        .iter()
        .map(str::to_owned)
        .collect();
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(fail)?;
        let mut row: Vec<Entry> = record.iter().map(Entry::new).collect();
        row.resize(columns.len(), Entry::new(""));
        rows.push(row);
    }
    Ok(Table {
        caption: "Every part of every claim".to_owned(),
        columns,
        rows,
    })
}

/// The tables of a Markdown page, each with the heading that it stands under.
pub fn tables(page: &str) -> Vec<Table> {
    let mut heading = "";
    let mut tables: Vec<Table> = Vec::new();
    let mut inside = false;
    for line in page.lines() {
        let row = line.trim();
        if !row.starts_with('|') {
            inside = false;
            if row.starts_with('#') {
                heading = row.trim_start_matches('#').trim();
            }
            continue;
        }
        let cells = cells(row);
        match tables.last_mut().filter(|_| inside) {
            None => tables.push(Table {
                caption: heading.to_owned(),
                columns: cells,
                rows: Vec::new(),
            }),
            Some(_) if cells.iter().all(|cell| is_rule(cell)) => {}
            Some(table) => {
                let mut row: Vec<Entry> = cells.iter().map(|cell| Entry::new(cell)).collect();
                row.resize(table.columns.len(), Entry::new(""));
                table.rows.push(row);
            }
        }
        inside = true;
    }
    tables
}

/// The cells of a line of a table; `\|` is a letter of a cell.
fn cells(row: &str) -> Vec<String> {
    let inner = row.strip_prefix('|').unwrap_or(row);
    let inner = inner.strip_suffix('|').unwrap_or(inner);
    let hidden = inner.replace("\\|", "\u{1}");
    let cells = hidden
        .split('|')
        .map(|cell| cell.trim().replace('\u{1}', "|"));
    cells.collect()
}

fn is_rule(cell: &str) -> bool {
    !cell.is_empty() && cell.chars().all(|c| matches!(c, '-' | ':'))
}

fn text(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path)
        .map_err(|error| Failure::io(path.display(), &error, "run `hullbench reproduce` again"))
}

/// What is in `folder`, by name.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let fail = |error| Failure::io(folder.display(), &error, "give a folder of reports");
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(fail)? {
        paths.push(entry.map_err(fail)?.path());
    }
    paths.sort();
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_found_with_their_headings() {
        let page = "# A\n\n## B\n\n| x | y |\n| --- | --: |\n| 1 | **a\\|b** |\n| 2 |\n\ntext\n\n| z |\n| - |\n| 3 |\n";
        let tables = tables(page);
        assert_eq!(tables.len(), 2);
        assert_eq!((tables[0].caption.as_str(), tables[0].rows.len()), ("B", 2));
        let bold = &tables[0].rows[0][1];
        assert!(bold.strong && bold.text == "a|b", "{bold:?}");
        assert_eq!(tables[0].rows[1].len(), 2);
        assert_eq!(tables[1].columns, ["z"]);
    }
}
