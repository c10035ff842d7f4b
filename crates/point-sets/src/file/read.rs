//! Reading points of the plane or of space from a text file.

use super::columns::{self, Column, Header, TakenColumn};
use super::delimiter::Delimiter;
use super::error::{FileError, Problem, shortened};
use super::records::{Failure, Record, Records};
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// What is known about a file beforehand; the default is nothing, and all is found out.
///
/// ```
/// use point_sets::file::{Header, ReadOptions};
/// let options: ReadOptions = ReadOptions { header: Header::Absent, ..ReadOptions::default() };
/// assert_eq!(options.columns, None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions<const D: usize = 2> {
    /// What separates fields; `None`: what the first record shows.
    pub delimiter: Option<Delimiter>,
    /// Whether the first record is a header.
    pub header: Header,
    /// The columns of the D coordinates; `None`: those whose names are coordinates that belong together, such as x
    /// and y, else the first D that hold numbers in the first record of data.
    pub columns: Option<[Column; D]>,
}

/// The points of a file, and how it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFile<const D: usize = 2> {
    /// The points, in the order of the file; at least one, all finite, at most `u32::MAX`.
    pub points: Vec<[f64; D]>,
    /// The line of each point, from 1.
    pub rows: Vec<u64>,
    /// The columns taken as coordinates.
    pub columns: [TakenColumn; D],
    /// The names of all columns, if there is a header.
    pub header: Option<Vec<String>>,
    /// What separates fields.
    pub delimiter: Delimiter,
}

/// Reads the points of the plane in the text file `path`.
///
/// # Errors
///
/// [`FileError`] names the file, the line, the column and the remedy; see [`Problem`] for all there are.
///
/// # Cost
///
/// One pass; memory for the points and their lines only.
///
/// ```
/// use point_sets::file::{ReadOptions, read2};
/// let path = std::env::temp_dir().join(format!("point-sets-doc-{}.txt", std::process::id()));
/// std::fs::write(&path, "# two towns\nname;lat;lon\nA;51.5;-0.1\nB;48.9;2.4\n")?;
/// let file = read2(&path, &ReadOptions::default())?;
/// assert_eq!(file.points, [[-0.1, 51.5], [2.4, 48.9]]);
/// assert_eq!(file.rows, [3, 4]);
/// assert_eq!(file.columns[0].to_string(), "field 3 (lon)");
///
/// std::fs::write(&path, "1,2\n3,4,5\n")?;
/// let error = read2(&path, &ReadOptions::default()).unwrap_err();
/// assert!(error.to_string().contains(".txt:2:5: 3 fields where line 1 has 2;"));
/// # std::fs::remove_file(&path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read2(path: &Path, options: &ReadOptions<2>) -> Result<PointFile<2>, FileError> {
    open(path, |source| read_from(source, options, u32::MAX as usize))
}

/// Reads the points of space in the text file `path`; otherwise as [`read2`].
///
/// # Errors
///
/// As [`read2`].
///
/// # Cost
///
/// As [`read2`].
///
/// ```
/// use point_sets::file::{ReadOptions, read3};
/// let path = std::env::temp_dir().join(format!("point-sets-doc3-{}.txt", std::process::id()));
/// std::fs::write(&path, "id z y x\n7 3 2 1\n8 6 5 4\n")?;
/// let file = read3(&path, &ReadOptions::default())?;
/// assert_eq!(file.points, [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
/// # std::fs::remove_file(&path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read3(path: &Path, options: &ReadOptions<3>) -> Result<PointFile<3>, FileError> {
    open(path, |source| read_from(source, options, u32::MAX as usize))
}

/// How many coordinates a point of the text file `path` seems to have, 2 or 3.
///
/// As many as the header names, such as x, y and z; else as many fields as are numbers in the first record of data;
/// `None` if that are more than 3. Anything wrong with the file beyond its first two records is left to the reader
/// proper.
///
/// # Errors
///
/// As [`read2`], about the first two records.
pub fn dimension(path: &Path, options: &ReadOptions) -> Result<Option<usize>, FileError> {
    open(path, |source| {
        let mut records = Records::new(source, options.delimiter);
        let Some(first) = records.next()? else {
            return Err(empty::<2>(records.line(), NOTHING));
        };
        if !columns::is_header(first, options.header, None::<&[Column; 2]>)? {
            return Ok(columns::dimension(&[], first));
        }
        let (names, line) = (first.names(), first.line);
        match records.next()? {
            Some(sample) => Ok(columns::dimension(&names, sample)),
            None => Err(empty::<2>(line, HEADER_ALONE)),
        }
    })
}

/// What `read` makes of the file, its failures placed in it.
fn open<T>(
    path: &Path,
    read: impl FnOnce(BufReader<File>) -> Result<T, Failure>,
) -> Result<T, FileError> {
    let result = match File::open(path) {
        Ok(file) => read(BufReader::with_capacity(1 << 17, file)),
        Err(error) => Err((None, Problem::Open(error))),
    };
    result.map_err(|(place, problem)| FileError {
        path: path.to_owned(),
        place: place.map(Box::new),
        problem,
    })
}

const NOTHING: &str = "the file is empty, or all comments and blank lines";
const HEADER_ALONE: &str = "there is a header and nothing else";

fn read_from<const D: usize>(
    source: impl BufRead,
    options: &ReadOptions<D>,
    limit: usize,
) -> Result<PointFile<D>, Failure> {
    let mut records = Records::new(source, options.delimiter);
    let asked = options.columns.as_ref();
    let Some(mut record) = records.next()? else {
        return Err(empty::<D>(records.line(), NOTHING));
    };
    let shape = Shape::of(record);
    let header = columns::is_header(record, options.header, asked)?.then(|| record.names());
    if header.is_some() {
        // Names are resolved even if no record follows, so that a wrong one is what gets reported.
        if asked.is_some() {
            columns::choose(asked, header.as_deref().unwrap_or_default(), record)?;
        }
        let header_line = records.line();
        record = match records.next()? {
            Some(record) => record,
            None => return Err(empty::<D>(header_line, HEADER_ALONE)),
        };
        shape.check(record)?;
    }
    let indices: [usize; D] =
        columns::choose(asked, header.as_deref().unwrap_or_default(), record)?;
    let columns = indices.map(|index| TakenColumn {
        number: index + 1,
        name: header.as_ref().map(|names| names[index].clone()),
    });

    let mut points = Vec::new();
    let mut rows = Vec::new();
    loop {
        shape.check(record)?;
        if points.len() == limit {
            return Err((Some(record.place(0)), Problem::TooManyPoints { limit }));
        }
        let mut point = [0.0; D];
        for (axis, value) in point.iter_mut().enumerate() {
            *value = coordinate(record, indices[axis], &columns[axis])?;
        }
        points.push(point);
        rows.push(record.line);
        record = match records.next()? {
            Some(record) => record,
            None => break,
        };
    }
    Ok(PointFile {
        points,
        rows,
        columns,
        header,
        delimiter: shape.delimiter,
    })
}

/// How many fields every record must have.
struct Shape {
    fields: usize,
    first_line: u64,
    delimiter: Delimiter,
}

impl Shape {
    fn of(first: Record<'_>) -> Self {
        Shape {
            fields: first.len(),
            first_line: first.line,
            delimiter: first.delimiter,
        }
    }

    /// A failure at the first field too many, or where the first missing one would be.
    fn check(&self, record: Record<'_>) -> Result<(), Failure> {
        if record.len() == self.fields {
            return Ok(());
        }
        let surplus = record.fields.get(self.fields).map(|field| field.start);
        let place = record.place(surplus.unwrap_or(record.text.len()));
        let problem = Problem::Ragged {
            found: record.len(),
            expected: self.fields,
            first_line: self.first_line,
            delimiter: self.delimiter.name(),
        };
        Err((Some(place), problem))
    }
}

fn coordinate(record: Record<'_>, index: usize, column: &TakenColumn) -> Result<f64, Failure> {
    let value = record.value(index);
    match value.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        parsed => Err(bad_coordinate(record, index, column, parsed.is_ok())),
    }
}

#[cold]
fn bad_coordinate(
    record: Record<'_>,
    index: usize,
    column: &TakenColumn,
    is_number: bool,
) -> Failure {
    let value = record.value(index);
    let text = shortened(value, 40);
    let problem = match value {
        "" => Problem::Missing,
        _ if is_number => Problem::NotFinite { text },
        _ => Problem::NotANumber {
            text,
            remedy: remedy(value),
        },
    };
    let mut place = record.place(record.fields[index].start);
    place.field = Some(column.clone());
    (Some(place), problem)
}

/// What is probably to be done about a field that is no number.
fn remedy(value: &str) -> &'static str {
    let digits_and = |others: &str| {
        value
            .chars()
            .all(|c| c.is_ascii_digit() || others.contains(c))
    };
    match value.to_lowercase().as_str() {
        "na" | "n/a" | "null" | "none" | "-" | "--" | "?" | "." => {
            "it marks a missing value: fill it in or remove the line"
        }
        text if text.contains(',') && digits_and("+-.eE,") => {
            "write a decimal point, and nothing between thousands"
        }
        text if text.contains('d') && digits_and("+-.dD") => {
            "write the exponent with e, as in 1e-9"
        }
        text if text.starts_with(char::is_alphabetic) => {
            "if the line is a header, say that there is one; else choose other columns or correct it"
        }
        _ => "write it as 12.5, -3 or 1e-9, or choose other columns",
    }
}

fn empty<const D: usize>(line: u64, found: &'static str) -> Failure {
    let place = super::Place {
        line: line.max(1),
        column: 1,
        field: None,
    };
    let example = if D == 2 { "1.5,2.25" } else { "1.5,2.25,3" };
    (Some(place), Problem::Empty { found, example })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_end_where_indices_end() {
        let text = "x,y\n1,2\n3,4\n5,6\n";
        let read = |limit| read_from::<2>(text.as_bytes(), &ReadOptions::default(), limit);
        assert_eq!(read(3).unwrap().points.len(), 3);
        let (place, problem) = read(2).unwrap_err();
        assert_eq!(place.map(|place| (place.line, place.column)), Some((4, 1)));
        let expected = "more than 2 points, and no more can be indexed; split the file";
        assert_eq!(problem.to_string(), expected);
    }

    #[test]
    fn a_reader_that_fails_is_reported_where_it_failed() {
        struct Failing;
        impl std::io::Read for Failing {
            fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
                Err(std::io::Error::other("the disc is gone"))
            }
        }
        let source = BufReader::new(std::io::Read::chain(&b"1,2\n"[..], Failing));
        let (place, problem) = read_from::<2>(source, &ReadOptions::default(), 10).unwrap_err();
        assert_eq!(place.map(|place| (place.line, place.column)), Some((2, 1)));
        assert_eq!(problem.to_string(), "cannot be read on: the disc is gone");
    }
}
