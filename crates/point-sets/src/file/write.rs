//! Writing points to a text file.

use std::io::{self, BufWriter, Write};

/// Writes `points` as CSV with the header `x,y`, one point a line.
///
/// Every number is the shortest decimal that reads back as the same bits, so
/// [`read2`](crate::file::read2) gives the same points again. `out` is buffered here and flushed.
///
/// # Errors
///
/// Those of `out`.
///
/// ```
/// let mut text = Vec::new();
/// point_sets::file::write_csv2(&mut text, &[[0.1, -0.0], [1e300, 5e-324]])?;
/// assert_eq!(text, b"x,y\n0.1,-0.0\n1e300,5e-324\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_csv2(out: impl Write, points: &[[f64; 2]]) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    writeln!(out, "x,y")?;
    for [x, y] in points {
        writeln!(out, "{x:?},{y:?}")?;
    }
    out.flush()
}

/// Writes points of space under the header `x,y,z`; otherwise as [`write_csv2`], for
/// [`read3`](crate::file::read3).
///
/// # Errors
///
/// Those of `out`.
pub fn write_csv3(out: impl Write, points: &[[f64; 3]]) -> io::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    writeln!(out, "x,y,z")?;
    for [x, y, z] in points {
        writeln!(out, "{x:?},{y:?},{z:?}")?;
    }
    out.flush()
}
