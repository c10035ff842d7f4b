//! Which method runs: registry entries by name, with a hint for a name that is not there.

use crate::failure::Failure;
use clap::ValueEnum;
use geometry_core::method::{Delaunay, PlanarHull, PlanarLayers, SpatialHull};
use hullkit::{Boundary, Method, Task};
use std::fmt::Display;

/// The methods that are taken where none is named: those of the front door.
pub mod default {
    /// For hulls in the plane.
    pub const HULL: &str = "fast-2d";
    /// For hulls in space.
    pub const HULL3: &str = "hull-3d";
    /// For layers.
    pub const LAYERS: &str = "fast-layers";
    /// For triangulations.
    pub const DELAUNAY: &str = "fast-delaunay";
}

/// Which boundary points count as vertices, on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BoundaryArg {
    /// Only the corners, where the boundary turns
    Extreme,
    /// Every distinct point on the boundary (Green and Silverman 1979)
    All,
}

impl From<BoundaryArg> for Boundary {
    fn from(arg: BoundaryArg) -> Self {
        match arg {
            BoundaryArg::Extreme => Boundary::Extreme,
            BoundaryArg::All => Boundary::All,
        }
    }
}

/// The hull method registered as `slug`, and how to run it.
///
/// # Errors
///
/// [`Failure::Usage`] if there is none, with the nearest name.
pub fn hull(slug: &str) -> Result<(&'static Method, PlanarHull), Failure> {
    let found = hullkit::method(slug);
    if let Some((method, Task::PlanarHull(task))) = found.map(|method| (method, method.task)) {
        return Ok((method, task));
    }
    Err(unfit(slug, "hull", found))
}

/// The layers method registered as `slug`, and how to run it.
///
/// # Errors
///
/// As [`hull`].
pub fn layers(slug: &str) -> Result<(&'static Method, PlanarLayers), Failure> {
    let found = hullkit::method(slug);
    if let Some((method, Task::PlanarLayers(task))) = found.map(|method| (method, method.task)) {
        return Ok((method, task));
    }
    Err(unfit(slug, "layers", found))
}

/// The method for hulls in space registered as `slug`, and how to run it.
///
/// # Errors
///
/// As [`hull`].
pub fn hull3(slug: &str) -> Result<(&'static Method, SpatialHull), Failure> {
    let found = hullkit::method(slug);
    if let Some((method, Task::SpatialHull(task))) = found.map(|method| (method, method.task)) {
        return Ok((method, task));
    }
    Err(unfit(slug, "hull-3d", found))
}

/// The method for triangulations registered as `slug`, and how to run it.
///
/// # Errors
///
/// As [`hull`].
pub fn delaunay(slug: &str) -> Result<(&'static Method, Delaunay), Failure> {
    let found = hullkit::method(slug);
    if let Some((method, Task::Delaunay(task))) = found.map(|method| (method, method.task)) {
        return Ok((method, task));
    }
    Err(unfit(slug, "delaunay", found))
}

/// The method registered as `slug`, whatever it computes.
///
/// # Errors
///
/// As [`hull`].
pub fn any(slug: &str) -> Result<&'static Method, Failure> {
    let names = || hullkit::methods().map(|method| method.slug);
    hullkit::method(slug).ok_or_else(|| unknown(slug, "method", names()))
}

/// What `method` computes, in one word.
pub fn computes(method: &Method) -> &'static str {
    match method.task {
        Task::PlanarHull(_) => "hull",
        Task::PlanarLayers(_) => "layers",
        Task::SpatialHull(_) => "hull-3d",
        Task::Delaunay(_) => "delaunay",
        _ => "other",
    }
}

/// The failure of a result of `method` in which the checker found faults; shows the first few.
pub fn not_certified(method: &Method, findings: &[impl Display]) -> Failure {
    Failure::Verification(format!(
        "the result of method '{}' is not certified: {}; please report it with the points, and take another method",
        method.slug,
        first_few(findings)
    ))
}

/// The first few of what a checker found.
pub fn first_few(findings: &[impl Display]) -> String {
    const SHOWN: usize = 3;
    let shown: Vec<_> = findings
        .iter()
        .take(SHOWN)
        .map(ToString::to_string)
        .collect();
    let more = match findings.len().saturating_sub(SHOWN) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    format!("{}{more}", shown.join("; "))
}

fn unfit(slug: &str, wanted: &str, found: Option<&Method>) -> Failure {
    let names = || {
        hullkit::methods()
            .filter(|method| computes(method) == wanted)
            .map(|method| method.slug)
    };
    match found {
        None => unknown(slug, &format!("{wanted} method"), names()),
        Some(method) => {
            let names: Vec<_> = names().collect();
            Failure::Usage(format!(
                "method '{slug}' computes {}, and this command needs a {wanted} method: {}",
                computes(method),
                names.join(", ")
            ))
        }
    }
}

/// The failure to find `name` among `names`, which suggests the nearest.
fn unknown(name: &str, what: &str, names: impl Iterator<Item = &'static str>) -> Failure {
    let hint = match nearest(name, names) {
        Some(near) => format!("did you mean '{near}'? "),
        None => String::new(),
    };
    Failure::Usage(format!(
        "there is no {what} '{name}'; {hint}`hullbench methods` lists them all"
    ))
}

/// The name that takes the fewest edits from `name`, unless that would replace most of it.
pub fn nearest<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    names
        .map(|candidate| (edits(name, candidate), candidate))
        .filter(|(edits, candidate)| 2 * edits <= name.len().max(candidate.len()))
        .min()
        .map(|(_, candidate)| candidate)
}

/// The fewest insertions, deletions and replacements of a character that turn `a` into `b`
/// (Levenshtein 1966), by rows of the table of distances between prefixes.
fn edits(a: &str, b: &str) -> usize {
    let mut row: Vec<usize> = (0..=b.chars().count()).collect();
    for (i, from) in (1..).zip(a.chars()) {
        let mut diagonal = std::mem::replace(&mut row[0], i);
        for (j, to) in (1..).zip(b.chars()) {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j];
            row[j] = replaced.min(row[j] + 1).min(row[j - 1] + 1);
        }
    }
    row[row.len() - 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_without_certificate_shows_the_first_findings() {
        let (method, _) = hull("gs").unwrap();
        let failure = not_certified(method, &["a", "b", "c", "d", "e"]);
        let text = failure.to_string();
        assert!(
            text.contains("'gs' is not certified: a; b; c; and 2 more; "),
            "{text}"
        );
        assert!(matches!(failure, Failure::Verification(_)));
    }

    #[test]
    fn edits_are_counted() {
        for (a, b, expected) in [
            ("", "", 0),
            ("", "gs", 2),
            ("gs", "gs", 0),
            ("kitten", "sitting", 3),
            ("jarvis-j4", "jarvis-j1", 1),
        ] {
            assert_eq!(edits(a, b), expected, "{a} to {b}");
            assert_eq!(edits(b, a), expected, "{b} to {a}");
        }
    }

    #[test]
    fn the_nearest_name_is_suggested_if_it_is_near() {
        let names = || ["gs", "graham", "monotone-chain"].into_iter();
        assert_eq!(nearest("gramham", names()), Some("graham"));
        assert_eq!(nearest("monotone", names()), Some("monotone-chain"));
        assert_eq!(nearest("delaunay", names()), None);
    }
}
