//! The real point sets of `data/points` are the ones that its README describes.

mod common;

use common::hull;
use point_sets::file::{ReadOptions, read2};
use point_sets::fingerprint;
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn real_sets_are_as_described() {
    for (name, columns, n, distinct, corners, boundary, print) in [
        ("airports", ["longitude", "latitude"], 3376, 3376, 1, 1, "airports"),
        (
            "earthquakes",
            ["longitude", "latitude"],
            1707,
            1706,
            0,
            0,
            "",
        ),
        (
            "penguins",
            ["flipper_length_mm", "body_mass_g"],
            342,
            305,
            0,
            0,
            "",
        ),
    ] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/points");
        let path = folder.join(format!("{name}.csv"));
        let file = read2(&path, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let taken = file.columns.map(|column| column.name.unwrap_or_default());
        assert_eq!(taken, columns, "{name}");

        let mut points = file.points;
        let full = fingerprint(&points).full();
        let mut seen = BTreeSet::new();
        let all = points.len();
        points.retain(|point| seen.insert(point.map(f64::to_bits)));
        let found = (
            all,
            points.len(),
            hull(&points, false).len(),
            hull(&points, true).len(),
        );
        assert_eq!(
            (found, &full[..]),
            ((n, distinct, corners, boundary), print),
            "{name}"
        );
    }
}
