//! The real point sets of `data/points` are the ones that its README describes.

mod common;

use common::hull;
use point_sets::file::{ReadOptions, read2};
use point_sets::fingerprint;
use std::collections::BTreeSet;
use std::path::Path;

/// Points, distinct points, corners of the hull, points on its boundary.
#[test]
fn real_sets_are_as_described() {
    for (name, columns, counts, print) in [
        (
            "airports",
            ["longitude", "latitude"],
            [3376, 3376, 13, 13],
            "258d68e766717ac42b786f67b2f35775a069cd7c4c656239edb6f7a0e30484a1",
        ),
        (
            "earthquakes",
            ["longitude", "latitude"],
            [1707, 1706, 12, 12],
            "c6822b68f1651bab948f21620e748778c057a162883bf0427b2e1413b031ae3e",
        ),
        (
            "penguins",
            ["flipper_length_mm", "body_mass_g"],
            [342, 305, 10, 13],
            "183c82e45107611f9e9728b28e4380bf2a9147abae627a81d9b005561e39a3e6",
        ),
    ] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/points");
        let path = folder.join(format!("{name}.csv"));
        let file = read2(&path, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let taken = file.columns.map(|column| column.name.unwrap_or_default());
        assert_eq!(taken, columns, "{name}");

        let all = file.points;
        assert_eq!(fingerprint(&all).full(), print, "{name}");
        let mut seen = BTreeSet::new();
        let mut distinct = all.clone();
        distinct.retain(|point| seen.insert(point.map(f64::to_bits)));
        let corners = hull(&distinct, false).len();
        let boundary = hull(&distinct, true).len();
        assert_eq!(
            [all.len(), distinct.len(), corners, boundary],
            counts,
            "{name}"
        );
    }
}
