//! Files of points of space: which columns are taken, and what is said where they cannot be.

use point_sets::file::{
    Column, FileError, Header, PointFile, ReadOptions, dimension, read3, write_csv3,
};
use point_sets::{Spec, fingerprint};
use std::io::Write;

fn file(content: &str) -> tempfile::NamedTempFile {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(content.as_bytes()).unwrap();
    file
}

fn read(content: &str, options: &ReadOptions<3>) -> Result<PointFile<3>, FileError> {
    read3(file(content).path(), options)
}

fn guess(content: &str) -> Option<usize> {
    dimension(file(content).path(), &ReadOptions::default()).unwrap()
}

#[test]
fn triples_of_names_are_known_and_else_the_first_three_numbers_are_taken() {
    for (content, numbers) in [
        ("id,z,y,x\n7,3,2,1\n", [4, 3, 2]),
        (
            "Easting (m);Northing (m);point;Height (m)\n1;2;8;3\n",
            [1, 2, 4],
        ),
        ("x3 x1 x2\n3 1 2\n", [2, 3, 1]),
        ("name,w,t,u,v\nA,1,2,3,4\n", [2, 3, 4]),
        ("1\t2\t3\t4\n", [1, 2, 3]),
    ] {
        let file = read(content, &ReadOptions::default()).unwrap();
        assert_eq!(
            file.columns.map(|column| column.number),
            numbers,
            "{content:?}"
        );
        assert_eq!(file.points, [[1.0, 2.0, 3.0]], "{content:?}");
    }
}

#[test]
fn columns_can_be_chosen() {
    let options = ReadOptions {
        columns: Some(["c", "2", "a"].map(|text| -> Column { text.parse().unwrap() })),
        ..ReadOptions::default()
    };
    assert_eq!(
        read("a,b,c\n1,2,3\n", &options).unwrap().points,
        [[3.0, 2.0, 1.0]]
    );
}

#[test]
fn the_dimension_is_that_of_the_names_or_the_numbers() {
    for (content, expected) in [
        ("x,y\n1,2\n", Some(2)),
        ("x,y,z\n1,2,3\n", Some(3)),
        ("x,y,mass,age\n1,2,3,4\n", Some(2)),
        ("lon,lat,depth\n1,2,3\n", Some(2)),
        ("name,u,v,w\nA,1,2,3\n", Some(3)),
        ("1 2 3\n", Some(3)),
        ("1;2\n", Some(2)),
        ("1,2,3,4\n", None),
        ("7\n", Some(2)),
    ] {
        assert_eq!(guess(content), expected, "{content:?}");
    }
    let absent = ReadOptions {
        header: Header::Present,
        ..ReadOptions::default()
    };
    assert_eq!(
        dimension(file("1,2,3\n4,5,6\n").path(), &absent).unwrap(),
        Some(3)
    );
    let error = dimension(file("").path(), &ReadOptions::default()).unwrap_err();
    assert!(
        error.to_string().contains("no points: the file is empty"),
        "{error}"
    );
}

#[test]
fn errors_speak_of_three_coordinates() {
    for (content, expected) in [
        (
            "",
            ":1:1: no points: the file is empty, or all comments and blank lines; give one point a line, such as 1.5,2.25,3",
        ),
        (
            "x,y\n1,2\n",
            ":2:1: \"1,2\" has 2 numeric of 2 fields, and a point needs 3; choose the columns, or the separator (now \",\")",
        ),
        (
            "x,y,z\n1,2,3\n4,5,six\n",
            ":3:5: field 3 (z): \"six\" is not a number; ",
        ),
        (
            "1,2,b\n",
            ":1:1: \"1,2,b\" may be a header or a point, since one of its fields is a number; say which, or correct it",
        ),
    ] {
        let error = read(content, &ReadOptions::default())
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn written_points_read_back_to_the_bit() {
    for spec in [
        "cauchy3",
        "near-coplanar",
        "moment-curve",
        "rounded:of=normal3,decimals=0",
    ] {
        let points = spec.parse::<Spec>().unwrap().generate3(1000, 11).unwrap();
        let mut text = Vec::new();
        write_csv3(&mut text, &points).unwrap();
        let back = read(std::str::from_utf8(&text).unwrap(), &ReadOptions::default()).unwrap();
        assert_eq!(fingerprint(&back.points), fingerprint(&points), "{spec}");
        assert_eq!(back.rows, (2..1002).collect::<Vec<u64>>());
    }
}
