//! The tables between marks of a Markdown file, so that a page shows the numbers of the last run.
//!
//! ```text
//! <!-- report:plane -->
//! the table of the definition `plane`: time over that of the baseline
//! <!-- /report:plane -->
//! ```
//!
//! Names of engines after that of the definition, `<!-- report:plane gs qhull -->`, make it the table of these.

use std::fmt;

/// What is wrong with the marks of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub what: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.line, self.what)
    }
}

/// A line that is a mark.
enum Mark<'a> {
    /// The name of a table, and the engines that are wanted in it.
    Begin(&'a str, Vec<&'a str>),
    End(&'a str),
}

/// `page` with what stands between the marks of NAME replaced by `table(NAME, ENGINES)`; how many tables that were comes with it.
///
/// # Errors
///
/// [`Fault`]: a name that `table` has nothing for, a mark without its other, a mark within another pair.
pub fn splice(
    page: &str,
    table: impl Fn(&str, &[&str]) -> Result<String, String>,
) -> Result<(String, usize), Fault> {
    let mut out = String::new();
    let mut open: Option<(usize, &str)> = None;
    let mut tables = 0;
    for (number, line) in (1..).zip(page.split_inclusive('\n')) {
        let fault = |what: String| Fault { line: number, what };
        match (mark(line), open) {
            (None, None) => out += line,
            (None, Some(_)) => {}
            (Some(Mark::Begin(name, engines)), None) => {
                let table = table(name, &engines).map_err(fault)?;
                out += line;
                out += &format!("\n{}\n", table.trim_end());
                out += "\n";
                open = Some((number, name));
                tables += 1;
            }
            (Some(Mark::End(name)), Some((_, opened))) if name == opened => {
                out += line;
                open = None;
            }
            (Some(Mark::Begin(name, _)), Some((line, opened))) => {
                let what = format!("report:{name} begins within report:{opened} of line {line}");
                return Err(fault(what));
            }
            (Some(Mark::End(name)), _) => {
                return Err(fault(format!("/report:{name} ends what has not begun")));
            }
        }
    }
    match open {
        Some((line, name)) => Err(Fault {
            line,
            what: format!("report:{name} has no end; add <!-- /report:{name} -->"),
        }),
        None => Ok((out, tables)),
    }
}

/// The mark that `line` is, if it is one.
fn mark(line: &str) -> Option<Mark<'_>> {
    let inner = line
        .trim()
        .strip_prefix("<!--")?
        .strip_suffix("-->")?
        .trim();
    match inner.strip_prefix('/') {
        None => {
            let mut words = inner.strip_prefix("report:")?.split_whitespace();
            Some(Mark::Begin(words.next()?, words.collect()))
        }
        Some(rest) => rest
            .strip_prefix("report:")
            .map(|name| Mark::End(name.trim())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(name: &str, engines: &[&str]) -> Result<String, String> {
        match name {
            "plane" => Ok(format!(
                "| {} |\n",
                [&["new"], engines].concat().join(" | ")
            )),
            _ => Err(format!("no definition is called '{name}'")),
        }
    }

    #[test]
    fn what_stands_between_marks_is_replaced_and_a_second_time_changes_nothing() {
        let page =
            "before\n<!-- report:plane -->\n| old |\n| older |\n<!-- /report:plane -->\nafter";
        let (once, tables) = splice(page, table).expect("spliced");
        assert_eq!(tables, 1);
        assert_eq!(
            once,
            "before\n<!-- report:plane -->\n\n| new |\n\n<!-- /report:plane -->\nafter"
        );
        assert_eq!(splice(&once, table).expect("again").0, once);
    }

    #[test]
    fn engines_may_be_named() {
        let page = "<!-- report:plane gs qhull -->\n<!-- /report:plane -->\n";
        let (spliced, _) = splice(page, table).expect("spliced");
        assert!(spliced.contains("\n| new | gs | qhull |\n"), "{spliced}");
    }

    #[test]
    fn faults_name_their_line() {
        let faults = [
            (
                "a\n<!-- report:plain -->\n<!-- /report:plain -->\n",
                "2: no definition is called 'plain'",
            ),
            ("<!-- report:plane -->\nb\n", "1: report:plane has no end"),
            (
                "a\nb\n<!-- /report:plane -->\n",
                "3: /report:plane ends what has not begun",
            ),
            (
                "<!-- report:plane -->\n<!-- /report:space -->\n",
                "2: /report:space ends",
            ),
            (
                "<!-- report:plane -->\n<!-- report:plane -->\n",
                "2: report:plane begins within",
            ),
        ];
        for (page, expected) in faults {
            let fault = splice(page, table).expect_err(page).to_string();
            assert!(fault.starts_with(expected), "{fault}");
        }
    }
}
