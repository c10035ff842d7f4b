//! The values of a PLY file, one after another, from text or from bytes.

use super::header::Scalar;
use crate::mesh_file::error::{Failure, MeshPlace, MeshProblem};
use crate::mesh_file::words::{Line, Lines};

/// What follows the header.
pub(super) enum Body<'a> {
    /// One element a line.
    Text {
        lines: Lines<'a>,
        line: Option<Line<'a>>,
    },
    /// Values without gaps.
    Bytes {
        content: &'a [u8],
        at: usize,
        endian: Endian,
    },
}

/// A place that may be asked for.
pub(super) enum Mark<'a> {
    /// The next word of a line.
    Word(Line<'a>),
    Place(MeshPlace),
}

impl Mark<'_> {
    /// Counts the characters before it.
    pub(super) fn place(&self) -> MeshPlace {
        match self {
            Mark::Word(line) => line.here(),
            Mark::Place(place) => *place,
        }
    }
}

/// The order of the bytes of a value.
#[derive(Clone, Copy)]
pub(super) enum Endian {
    Little,
    Big,
}

impl<'a> Body<'a> {
    /// The text of `content` from `start`.
    pub(super) fn text(content: &'a [u8], start: usize) -> Result<Self, Failure> {
        let mut lines = Lines::new(content, None)?;
        lines.skip_to(
            content[..start]
                .iter()
                .filter(|byte| **byte == b'\n')
                .count(),
        );
        Ok(Body::Text { lines, line: None })
    }

    /// The bytes of `content` from `start`.
    pub(super) fn binary(content: &'a [u8], start: usize, endian: Endian) -> Self {
        Body::Bytes {
            content,
            at: start,
            endian,
        }
    }

    /// Goes on to the next element, which is `expected`.
    pub(super) fn begin(&mut self, expected: &'static str) -> Result<(), Failure> {
        if let Body::Text { lines, line } = self {
            *line = Some(lines.expect(expected)?);
        }
        Ok(())
    }

    /// Where the next value is.
    pub(super) fn mark(&self) -> Mark<'a> {
        match self {
            Body::Text {
                line: Some(line), ..
            } => Mark::Word(*line),
            Body::Text { lines, .. } => Mark::Place(lines.end()),
            Body::Bytes { at, .. } => Mark::Place(MeshPlace::Byte(*at)),
        }
    }

    /// The next value, which is `expected`. Every type fits `f64`.
    pub(super) fn scalar(
        &mut self,
        scalar: Scalar,
        expected: &'static str,
    ) -> Result<f64, Failure> {
        match self {
            Body::Text {
                line: Some(line), ..
            } => line.number(expected),
            Body::Text { lines, .. } => Err((lines.end(), ends(expected))),
            Body::Bytes {
                content,
                at,
                endian,
            } => {
                let rest = &content[*at..];
                let (value, size) = decode(rest, scalar, *endian)
                    .ok_or((MeshPlace::Byte(content.len()), ends(expected)))?;
                *at += size;
                Ok(value)
            }
        }
    }

    /// The next value as a finite coordinate.
    pub(super) fn coordinate(&mut self, scalar: Scalar) -> Result<f64, Failure> {
        let mark = self.mark();
        let value = self.scalar(scalar, "a coordinate")?;
        if value.is_finite() {
            return Ok(value);
        }
        let found = value.to_string();
        Err((mark.place(), MeshProblem::NotFinite { found }))
    }

    /// The next value as a whole number that is not negative.
    pub(super) fn index(
        &mut self,
        scalar: Scalar,
        expected: &'static str,
    ) -> Result<usize, Failure> {
        let mark = self.mark();
        let value = self.scalar(scalar, expected)?;
        if value >= 0.0 && value.fract() == 0.0 {
            return Ok(value as usize);
        }
        let found = value.to_string();
        Err((mark.place(), MeshProblem::Expected { expected, found }))
    }
}

fn ends(expected: &'static str) -> MeshProblem {
    MeshProblem::Ends {
        what: "file",
        expected,
    }
}

/// The value at the beginning of `bytes`, and how many bytes it has.
fn decode(bytes: &[u8], scalar: Scalar, endian: Endian) -> Option<(f64, usize)> {
    /// The first bytes of a value in little-endian order.
    fn first<const N: usize>(bytes: &[u8], endian: Endian) -> Option<[u8; N]> {
        let mut first = *bytes.first_chunk::<N>()?;
        if let Endian::Big = endian {
            first.reverse();
        }
        Some(first)
    }
    Some(match scalar {
        Scalar::I8 => (f64::from(i8::from_le_bytes(first(bytes, endian)?)), 1),
        Scalar::U8 => (f64::from(u8::from_le_bytes(first(bytes, endian)?)), 1),
        Scalar::I16 => (f64::from(i16::from_le_bytes(first(bytes, endian)?)), 2),
        Scalar::U16 => (f64::from(u16::from_le_bytes(first(bytes, endian)?)), 2),
        Scalar::I32 => (f64::from(i32::from_le_bytes(first(bytes, endian)?)), 4),
        Scalar::U32 => (f64::from(u32::from_le_bytes(first(bytes, endian)?)), 4),
        Scalar::F32 => (f64::from(f32::from_le_bytes(first(bytes, endian)?)), 4),
        Scalar::F64 => (f64::from_le_bytes(first(bytes, endian)?), 8),
    })
}
