//! What a failure leaves behind: the points in a file, the message of a panic.

use std::any::Any;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Writes the points as lines `x,y` or `x,y,z`, each number the shortest that reads back to the same bits, and says
/// where: a file in the test's own folder, named after the failure.
pub(super) fn save<const D: usize>(failure: &str, points: &[[f64; D]]) -> String {
    match write(failure, points) {
        Ok(path) => format!("points saved in {}", path.display()),
        Err(error) => format!("the points could not be saved: {error}"),
    }
}

fn write<const D: usize>(failure: &str, points: &[[f64; D]]) -> std::io::Result<PathBuf> {
    let folder =
        std::env::var_os("CARGO_TARGET_TMPDIR").map_or_else(std::env::temp_dir, PathBuf::from);
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || "-.".contains(c) {
            c
        } else {
            '_'
        }
    };
    let name: String = failure.chars().map(plain).collect();
    let path = folder.join(name + ".csv");
    let mut text = ["x", "y", "z"][..D].join(",") + "\n";
    for point in points {
        let numbers = point.map(|x| format!("{x:?}"));
        let _ = writeln!(text, "{}", numbers.join(","));
    }
    std::fs::write(&path, text)?;
    Ok(path)
}

/// The points themselves, on a line of their own, if they are few.
pub(super) fn shown<const D: usize>(points: &[[f64; D]]) -> String {
    if points.len() <= 12 {
        format!("\npoints: {points:?}")
    } else {
        String::new()
    }
}

/// The message of a caught panic.
pub(super) fn message(panic: &(dyn Any + Send)) -> &str {
    panic
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| panic.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("(no message)")
}
