//! Which columns of a file hold x and y, and whether it begins with a header.

use super::error::{Problem, shortened};
use super::records::{Failure, Record};
use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

/// Whether the first record is a header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Header {
    /// Find out: a record without a number is a header, and so is one that names a pair of coordinates.
    #[default]
    Auto,
    /// It is.
    Present,
    /// It is a point.
    Absent,
}

/// A column asked for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Column {
    /// By its name in the header; capital letters are distinguished only where that is needed.
    Name(String),
    /// By its number, from 1.
    Number(usize),
}

/// A whole number is a [`Column::Number`], anything else a [`Column::Name`].
impl FromStr for Column {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        let text = text.trim();
        Ok(text
            .parse()
            .map_or_else(|_| Column::Name(text.to_owned()), Column::Number))
    }
}

/// A column that was read.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct TakenColumn {
    /// Its number, from 1.
    pub number: usize,
    /// Its name, if there is a header.
    pub name: Option<String>,
}

impl fmt::Display for TakenColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "field {}", self.number)?;
        match &self.name {
            Some(name) => write!(f, " ({name})"),
            None => Ok(()),
        }
    }
}

/// Names of pairs of coordinates, x before y, in lower case.
const PAIRS: &[(&[&str], &[&str])] = &[
    (&["x"], &["y"]),
    (&["x0"], &["y0"]),
    (&["x1"], &["y1"]),
    (&["lon", "long", "lng", "longitude"], &["lat", "latitude"]),
    (
        &["easting", "eastings", "east"],
        &["northing", "northings", "north"],
    ),
    (&["x0"], &["x1"]),
    (&["x1"], &["x2"]),
];

/// What a field of the first record looks like.
#[derive(Clone, Copy, PartialEq)]
enum Look {
    Number,
    /// It begins like a number and is none, such as `1,5` or `2.x`.
    Almost,
    Word,
}

fn look(value: &str) -> Look {
    if value.parse::<f64>().is_ok() {
        return Look::Number;
    }
    let digits = value.trim_start_matches(['+', '-', '.']);
    if digits.starts_with(|letter: char| letter.is_ascii_digit()) {
        Look::Almost
    } else {
        Look::Word
    }
}

/// Whether `first` is a header.
pub(super) fn is_header(
    first: Record<'_>,
    header: Header,
    asked: Option<&[Column; 2]>,
) -> Result<bool, Failure> {
    match header {
        Header::Present => return Ok(true),
        Header::Absent => return Ok(false),
        Header::Auto => {}
    }
    let by_name = |column: &Column| matches!(column, Column::Name(_));
    if asked.is_some_and(|asked| asked.iter().any(by_name)) || known_pair(&first.names()).is_some()
    {
        return Ok(true);
    }
    let mut judged: Vec<usize> = (0..first.len()).collect();
    let mut reason = "one of its fields is a number";
    if let Some(asked) = asked {
        judged = resolve_both(asked, first, &[])?.to_vec();
        reason = "one of the chosen fields is a number and the other is not";
    }
    let words = judged
        .iter()
        .filter(|&&index| look(first.value(index)) == Look::Word)
        .count();
    match (words, judged.len() - words) {
        (_, 0) => Ok(true),
        (0, _) => Ok(false),
        (_, numbers) if numbers >= 2 => Ok(false),
        _ => {
            let text = shortened(first.text, 60);
            Err((Some(first.place(0)), Problem::Ambiguous { text, reason }))
        }
    }
}

/// The indices, from 0, of the columns to take: those asked for, else those the header names as a pair of
/// coordinates, else the first two in which `sample`, the first record of data, has numbers.
pub(super) fn choose(
    asked: Option<&[Column; 2]>,
    names: &[String],
    sample: Record<'_>,
) -> Result<[usize; 2], Failure> {
    if let Some(asked) = asked {
        return resolve_both(asked, sample, names);
    }
    if let Some(pair) = known_pair(names) {
        return Ok(pair);
    }
    let looks: Vec<Look> = (0..sample.len())
        .map(|index| look(sample.value(index)))
        .collect();
    let having = |wanted: &[Look]| -> Vec<usize> {
        (0..looks.len())
            .filter(|&index| wanted.contains(&looks[index]))
            .collect()
    };
    let numeric = having(&[Look::Number]);
    // What begins like a number is taken for one where numbers are short, so that the error is about it.
    match (&numeric[..], &having(&[Look::Number, Look::Almost])[..]) {
        (&[x, y, ..], _) | (_, &[x, y, ..]) => Ok([x, y]),
        _ => Err((Some(sample.place(0)), too_few(sample, numeric.len()))),
    }
}

fn too_few(record: Record<'_>, numeric: usize) -> Problem {
    Problem::TooFewColumns {
        text: shortened(record.text, 60),
        numeric,
        count: record.len(),
        delimiter: record.delimiter.name(),
    }
}

fn resolve_both(
    asked: &[Column; 2],
    record: Record<'_>,
    names: &[String],
) -> Result<[usize; 2], Failure> {
    let [x, y] = asked;
    Ok([resolve(x, record, names)?, resolve(y, record, names)?])
}

fn resolve(column: &Column, record: Record<'_>, names: &[String]) -> Result<usize, Failure> {
    let count = record.len();
    let problem = match column {
        Column::Number(number) if (1..=count).contains(number) => return Ok(number - 1),
        Column::Number(number) => Problem::NoSuchNumber {
            number: *number,
            count,
            delimiter: record.delimiter.name(),
        },
        Column::Name(name) => match position(names, name) {
            Some(index) => return Ok(index),
            None => Problem::NoSuchName {
                name: name.clone(),
                nearest: crate::error::nearest(name, names.iter().map(String::as_str))
                    .map(str::to_owned),
                names: names.to_vec(),
            },
        },
    };
    Err((Some(record.place(0)), problem))
}

/// Where `name` is among `names`: spelled alike, else spelled alike but for capital letters.
fn position(names: &[String], name: &str) -> Option<usize> {
    let same = names.iter().position(|other| other == name);
    same.or_else(|| {
        names
            .iter()
            .position(|other| other.to_lowercase() == name.to_lowercase())
    })
}

/// The first of [`PAIRS`] of which both are among `names`, capital letters and units in brackets aside.
fn known_pair(names: &[String]) -> Option<[usize; 2]> {
    let plain: Vec<String> = names
        .iter()
        .map(|name| {
            name.split(['(', '['])
                .next()
                .unwrap_or_default()
                .trim()
                .to_lowercase()
        })
        .collect();
    let find = |spellings: &[&str]| {
        plain
            .iter()
            .position(|name| spellings.contains(&name.as_str()))
    };
    PAIRS.iter().find_map(|(x, y)| Some([find(x)?, find(y)?]))
}
