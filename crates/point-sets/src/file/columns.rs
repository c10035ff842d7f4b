//! Which columns of a file hold the coordinates, and whether it begins with a header.

use super::error::{Problem, shortened};
use super::records::{Failure, Record};
use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

/// Whether the first record is a header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Header {
    /// Find out: a record without a number is a header, and so is one that names a pair or a triple of coordinates.
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

/// The spellings of one coordinate.
type Spellings = &'static [&'static str];

/// Names of coordinates that belong together, in order and in lower case. Longitude and latitude are angles, so no
/// height makes them a triple.
const TUPLES: &[&[Spellings]] = &[
    &[&["x"], &["y"], &["z"]],
    &[&["x0"], &["y0"], &["z0"]],
    &[&["x1"], &["y1"], &["z1"]],
    &[EAST, NORTH, &["height", "elevation", "altitude", "up", "z"]],
    &[&["x0"], &["x1"], &["x2"]],
    &[&["x1"], &["x2"], &["x3"]],
    &[&["x"], &["y"]],
    &[&["x0"], &["y0"]],
    &[&["x1"], &["y1"]],
    &[&["lon", "long", "lng", "longitude"], &["lat", "latitude"]],
    &[EAST, NORTH],
    &[&["x0"], &["x1"]],
    &[&["x1"], &["x2"]],
];

const EAST: Spellings = &["easting", "eastings", "east"];
const NORTH: Spellings = &["northing", "northings", "north"];

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
pub(super) fn is_header<const D: usize>(
    first: Record<'_>,
    header: Header,
    asked: Option<&[Column; D]>,
) -> Result<bool, Failure> {
    match header {
        Header::Present => return Ok(true),
        Header::Absent => return Ok(false),
        Header::Auto => {}
    }
    let by_name = |column: &Column| matches!(column, Column::Name(_));
    if asked.is_some_and(|asked| asked.iter().any(by_name)) || known::<2>(&first.names()).is_some()
    {
        return Ok(true);
    }
    let mut judged: Vec<usize> = (0..first.len()).collect();
    let mut reason = "one of its fields is a number";
    if let Some(asked) = asked {
        judged = resolve_all(asked, first, &[])?.to_vec();
        reason = "one of the chosen fields is a number and another is not";
    }
    let words = judged
        .iter()
        .filter(|&&index| look(first.value(index)) == Look::Word)
        .count();
    match (words, judged.len() - words) {
        (_, 0) => Ok(true),
        (0, _) => Ok(false),
        (_, numbers) if numbers >= D => Ok(false),
        _ => {
            let text = shortened(first.text, 60);
            Err((Some(first.place(0)), Problem::Ambiguous { text, reason }))
        }
    }
}

/// The indices, from 0, of the columns to take: those asked for, else those the header names as coordinates that
/// belong together, else the first D in which `sample`, the first record of data, has numbers.
pub(super) fn choose<const D: usize>(
    asked: Option<&[Column; D]>,
    names: &[String],
    sample: Record<'_>,
) -> Result<[usize; D], Failure> {
    if let Some(asked) = asked {
        return resolve_all(asked, sample, names);
    }
    if let Some(known) = known(names) {
        return Ok(known);
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
    let almost = having(&[Look::Number, Look::Almost]);
    match (numeric.first_chunk(), almost.first_chunk()) {
        (Some(taken), _) | (None, Some(taken)) => Ok(*taken),
        _ => Err((Some(sample.place(0)), too_few(sample, numeric.len(), D))),
    }
}

/// How many coordinates a point seems to have, 2 or 3: as many as the header names, else as many fields as are
/// numbers in `sample`, the first record of data; `None` if there are more.
pub(super) fn dimension(names: &[String], sample: Record<'_>) -> Option<usize> {
    if known::<3>(names).is_some() {
        return Some(3);
    }
    if known::<2>(names).is_some() {
        return Some(2);
    }
    let is_number = |&index: &usize| look(sample.value(index)) == Look::Number;
    match (0..sample.len()).filter(is_number).count() {
        0..=2 => Some(2),
        3 => Some(3),
        _ => None,
    }
}

fn too_few(record: Record<'_>, numeric: usize, needed: usize) -> Problem {
    Problem::TooFewColumns {
        text: shortened(record.text, 60),
        numeric,
        needed,
        count: record.len(),
        delimiter: record.delimiter.name(),
    }
}

fn resolve_all<const D: usize>(
    asked: &[Column; D],
    record: Record<'_>,
    names: &[String],
) -> Result<[usize; D], Failure> {
    let mut indices = [0; D];
    for (index, column) in indices.iter_mut().zip(asked) {
        *index = resolve(column, record, names)?;
    }
    Ok(indices)
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

/// The first D of [`TUPLES`] that are all among `names`, capital letters and units in brackets aside.
fn known<const D: usize>(names: &[String]) -> Option<[usize; D]> {
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
    let find = |spellings: &Spellings| {
        plain
            .iter()
            .position(|name| spellings.contains(&name.as_str()))
    };
    TUPLES.iter().find_map(|tuple| {
        let found: Option<Vec<usize>> = tuple.iter().map(find).collect();
        found?.try_into().ok()
    })
}
