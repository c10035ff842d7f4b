//! A text cut into lines of words, each word with its place.

use super::error::{Failure, MeshPlace, MeshProblem};
use crate::file::shortened;
use std::str::FromStr;

/// The lines of a text that hold words.
pub(super) struct Lines<'a> {
    rest: std::iter::Enumerate<std::str::Lines<'a>>,
    comment: Option<char>,
    /// The place after the last line.
    end: MeshPlace,
}

/// The words of one line.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    text: &'a str,
    rest: &'a str,
    number: usize,
}

/// A word and where it begins. Characters are counted only when somebody asks, since lines may be long.
#[derive(Clone, Copy)]
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    line: Line<'a>,
    offset: usize,
}

impl<'a> Lines<'a> {
    /// The lines of `content`; what follows `comment` in a line is passed over.
    pub(super) fn new(content: &'a [u8], comment: Option<char>) -> Result<Self, Failure> {
        let text = std::str::from_utf8(content).map_err(|error| {
            let before = String::from_utf8_lossy(&content[..error.valid_up_to()]);
            (end_of(&before), MeshProblem::NotUtf8)
        })?;
        Ok(Lines {
            rest: text.trim_start_matches('\u{feff}').lines().enumerate(),
            comment,
            end: end_of(text),
        })
    }

    /// Passes over the first `count` lines, which must not yet have been read.
    pub(super) fn skip_to(&mut self, count: usize) {
        self.rest.by_ref().take(count).for_each(drop);
    }

    /// The place after the last line.
    pub(super) fn end(&self) -> MeshPlace {
        self.end
    }

    /// The next line that holds a word, or the failure that the file ends where `expected` is.
    pub(super) fn expect(&mut self, expected: &'static str) -> Result<Line<'a>, Failure> {
        let what = "file";
        self.next()
            .ok_or((self.end, MeshProblem::Ends { what, expected }))
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        let comment = self.comment;
        self.rest.by_ref().find_map(|(index, text)| {
            let text = match comment.and_then(|comment| text.split_once(comment)) {
                Some((before, _)) => before,
                None => text,
            };
            let line = Line {
                text,
                rest: text,
                number: index + 1,
            };
            (!text.trim().is_empty()).then_some(line)
        })
    }
}

impl<'a> Line<'a> {
    /// The next word, or the failure that the line ends where `expected` is.
    pub(super) fn expect(&mut self, expected: &'static str) -> Result<Word<'a>, Failure> {
        let what = "line";
        self.next().ok_or_else(|| {
            let end = self.place(self.text.len());
            (end, MeshProblem::Ends { what, expected })
        })
    }

    /// The next word as a number that is `expected`.
    pub(super) fn number<T: FromStr>(&mut self, expected: &'static str) -> Result<T, Failure> {
        let word = self.expect(expected)?;
        word.text.parse().map_err(|_| word.is_not(expected))
    }

    /// The next word as a finite coordinate.
    pub(super) fn coordinate(&mut self) -> Result<f64, Failure> {
        let word = self.expect("a coordinate")?;
        match word.text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => {
                let found = shortened(word.text, 40);
                Err((word.place(), MeshProblem::NotFinite { found }))
            }
            Err(_) => Err(word.is_not("a coordinate")),
        }
    }

    /// The next three words as a point.
    pub(super) fn point(&mut self) -> Result<[f64; 3], Failure> {
        Ok([self.coordinate()?, self.coordinate()?, self.coordinate()?])
    }

    /// The next word as the index, from 0, of one of `count` points.
    pub(super) fn corner(&mut self, count: usize) -> Result<u32, Failure> {
        let word = self.expect("a corner")?;
        let index: i64 = word.text.parse().map_err(|_| word.is_not("a corner"))?;
        match u32::try_from(index) {
            Ok(corner) if (corner as usize) < count => Ok(corner),
            _ => Err(word.is_no_point(count)),
        }
    }

    /// Where the line begins.
    pub(super) fn start(&self) -> MeshPlace {
        self.place(0)
    }

    /// Where the next word begins, or the line ends.
    pub(super) fn here(&self) -> MeshPlace {
        self.place(self.text.len() - self.rest.trim_start().len())
    }

    fn place(&self, offset: usize) -> MeshPlace {
        MeshPlace::Text {
            line: self.number,
            column: self.text[..offset].chars().count() + 1,
        }
    }
}

impl<'a> Iterator for Line<'a> {
    type Item = Word<'a>;

    fn next(&mut self) -> Option<Word<'a>> {
        let rest = self.rest.trim_start();
        let offset = self.text.len() - rest.len();
        let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
        let (text, after) = rest.split_at(length);
        self.rest = after;
        let line = *self;
        (!text.is_empty()).then_some(Word { text, line, offset })
    }
}

impl Word<'_> {
    /// Where it begins.
    pub(super) fn place(self) -> MeshPlace {
        self.line.place(self.offset)
    }

    /// The failure that this word is not `expected`.
    pub(super) fn is_not(self, expected: &'static str) -> Failure {
        let found = shortened(self.text, 40);
        (self.place(), MeshProblem::Expected { expected, found })
    }

    /// The failure that this word names none of `count` points.
    pub(super) fn is_no_point(self, count: usize) -> Failure {
        let found = shortened(self.text, 40);
        (self.place(), MeshProblem::NoSuchPoint { found, count })
    }
}

/// The place after `text`.
fn end_of(text: &str) -> MeshPlace {
    let start = text.rfind('\n').map_or(0, |end| end + 1);
    MeshPlace::Text {
        line: text.matches('\n').count() + 1,
        column: text[start..].chars().count() + 1,
    }
}
