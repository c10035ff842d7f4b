//! Points of the plane and of space in text files, in and out.
//!
//! [`read2`] and [`read3`] take what people have: comma, semicolon, tab or blanks between fields; a header or none; blank
//! lines, comment lines (`#`, `//`), a byte order mark, Windows line ends, quoted fields. What is not said in
//! [`ReadOptions`] is found out, and [`PointFile`] says what was found. Nothing is guessed about a number: a
//! field that is not one is a [`FileError`] with file, line and column, and what to do about it.
//!
//! [`write_csv2`] and [`write_csv3`] print the shortest decimals that read back as the same bits.
//!
//! Records are split here and not by a library because every error names the character at which it is, and
//! every point the line it came from, also behind comments, blank lines and quoted line breaks.

mod columns;
mod delimiter;
mod error;
mod read;
mod records;
mod write;

pub use columns::{Column, Header, TakenColumn};
pub use delimiter::Delimiter;
pub(crate) use error::shortened;
pub use error::{FileError, Place, Problem};
pub use read::{PointFile, ReadOptions, dimension, read2, read3};
pub use write::{write_csv2, write_csv3};
