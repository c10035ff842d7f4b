//! `hullbench hull` on points of space.

use crate::workshop::{CUBE, Workshop, value};
use point_sets::mesh_file::read_mesh;
use serde_json::Value;

#[test]
fn three_columns_make_a_hull_in_space() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    let summary = shop.run("hull cube.csv").stdout();
    for (label, expected) in [
        ("points", "11, of which 10 distinct"),
        ("dimension", "3"),
        ("vertices", "8"),
        ("edges", "12"),
        ("facets", "6"),
        ("area", "24.0"),
        (
            "certificate",
            "proved: 8 vertices + 1 copies of them + 1 on the boundary + 1 inside = 11 points",
        ),
    ] {
        assert_eq!(value(&summary, label), expected, "{label}");
    }
    let volume: f64 = value(&summary, "volume").parse().unwrap();
    assert!((volume - 8.0).abs() < 1e-12, "{volume}");
    assert!(value(&summary, "centroid").starts_with("(1.0"), "{summary}");
    assert!(summary.contains("z in field 4 (z)"), "{summary}");
}

#[test]
fn the_dimension_can_be_said_or_is_asked_for() {
    let shop = Workshop::new(&[
        ("cube.csv", CUBE),
        ("four.csv", "1,2,3,4\n5,6,7,9\n0,1,1,0\n4,0,0,1\n"),
    ]);
    let plane = shop.run("hull cube.csv --dimension 2").stdout();
    assert_eq!(value(&plane, "area"), "4.0");
    let plane = shop.run("hull cube.csv --columns z,x").stdout();
    assert_eq!(value(&plane, "dimension"), "2");
    let message = shop.run("hull four.csv").failure(2);
    assert!(message.contains("--dimension 2 or 3"), "{message}");
    for (options, dimension) in [
        ("--dimension 3", "3"),
        ("--dimension 2", "2"),
        ("--columns 2,3,4", "3"),
    ] {
        let summary = shop.run(&format!("hull four.csv {options}")).stdout();
        assert_eq!(value(&summary, "dimension"), dimension, "{options}");
    }
    let message = shop
        .run("hull four.csv --dimension 3 --columns 1,2")
        .failure(2);
    assert!(message.contains("name 3 --columns"), "{message}");
    let message = shop.run("hull cube.csv --method gs").failure(2);
    assert!(message.contains("needs a hull-3d method: "), "{message}");
    let message = shop.run("hull cube.csv --boundary all").failure(2);
    assert!(
        message.contains("in space only extreme points"),
        "{message}"
    );
    let message = shop.run("hull --set disc --dimension 3").failure(2);
    assert!(message.contains("disc is a set of the plane"), "{message}");
}

#[test]
fn meshes_hold_the_facets_to_the_bit() {
    let shop = Workshop::new(&[]);
    let json = shop.run("hull --set cauchy3 -n 500 --format json").stdout();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["schema"], "hullbench/hull-3d/1");
    let (vertices, facets) = (
        json["vertices"].as_array().unwrap(),
        json["facets"].as_array().unwrap(),
    );
    for name in ["hull.off", "hull.obj", "hull.ply"] {
        shop.run(&format!("hull --set cauchy3 -n 500 -o {name}"))
            .stdout();
        let mesh = read_mesh(&shop.folder.path().join(name)).unwrap();
        assert_eq!(
            (mesh.points.len(), mesh.polygons.len()),
            (vertices.len(), facets.len()),
            "{name}"
        );
        for (point, vertex) in mesh.points.iter().zip(vertices) {
            assert_eq!(
                *point,
                ["x", "y", "z"].map(|axis| vertex[axis].as_f64().unwrap()),
                "{name}"
            );
        }
        for (polygon, facet) in mesh.polygons.iter().zip(facets) {
            let indices: Vec<_> = polygon
                .iter()
                .map(|&corner| &vertices[corner as usize]["index"])
                .collect();
            assert_eq!(
                indices,
                facet.as_array().unwrap().iter().collect::<Vec<_>>(),
                "{name}"
            );
        }
    }
    let text = shop
        .run("hull --set cauchy3 -n 500 --format ply-text")
        .stdout();
    assert!(text.starts_with("ply\nformat ascii 1.0\n"), "{text}");
}

#[test]
fn stl_warns_that_it_rounds() {
    let shop = Workshop::new(&[("far.csv", "x,y,z\n0,0,0\n1e300,0,0\n0,1,0\n0,0,1\n")]);
    let outcome = shop.run("hull --set ball -n 50 -o hull.stl");
    assert_eq!(outcome.code, Some(0));
    assert!(
        outcome
            .stderr
            .contains("\nwarning: STL holds coordinates in single precision: "),
        "{outcome:?}"
    );
    let message = shop.run("hull far.csv -o far.stl").failure(3);
    assert!(message.contains("beyond single precision"), "{message}");
    assert_eq!(shop.names(), ["far.csv", "hull.stl"]);
}

#[test]
fn vertices_are_written_as_csv() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    let csv = shop.run("hull cube.csv -o -").stdout();
    assert!(
        csv.starts_with("order,index,line,x,y,z\n0,0,2,0.0,0.0,0.0\n1,1,3,2.0,0.0,0.0\n"),
        "{csv}"
    );
    assert_eq!(csv.lines().count(), 9);
    let message = shop.run("hull cube.csv -o cube.svg").failure(2);
    assert!(
        message.contains(".csv, .json, .off, .obj, .ply"),
        "{message}"
    );
}

#[test]
fn every_method_in_space_gives_the_same_hull() {
    let shop = Workshop::new(&[]);
    let listed = shop.run("methods --format json").stdout();
    let listed: Value = serde_json::from_str(&listed).unwrap();
    let in_space = |method: &&Value| method["computes"] == "hull-3d";
    let hulls: Vec<_> = listed
        .as_array()
        .unwrap()
        .iter()
        .filter(in_space)
        .map(|method| method["slug"].as_str().unwrap())
        .map(|slug| {
            shop.run(&format!(
                "hull --set minkowski -n 80 --format off --method {slug}"
            ))
            .stdout()
        })
        .collect();
    assert!(hulls.len() >= 2);
    assert!(hulls.iter().all(|hull| *hull == hulls[0]));
}

#[test]
fn flat_points_of_space_have_a_hull() {
    let shop = Workshop::new(&[
        ("plane.csv", "x,y,z\n0,0,0\n2,0,2\n2,2,2\n0,2,0\n1,1,1\n"),
        ("line.csv", "x,y,z\n0,0,0\n2,2,2\n1,1,1\n"),
        ("one.csv", "x,y,z\n1,2,3\n1,2,3\n"),
    ]);
    for (file, dimension, vertices) in [
        ("plane", "2", 4),
        ("line", "1: all points are on one line", 2),
        ("one", "0: all points are copies of one", 1),
    ] {
        let summary = shop.run(&format!("hull {file}.csv")).stdout();
        assert_eq!(value(&summary, "dimension"), dimension);
        shop.run(&format!("hull {file}.csv -o {file}.off")).stdout();
        let mesh = read_mesh(&shop.folder.path().join(format!("{file}.off"))).unwrap();
        assert_eq!(
            (mesh.points.len(), mesh.polygons.len()),
            (vertices, usize::from(file == "plane"))
        );
        let proved = shop.run(&format!("check {file}.csv {file}.off")).stdout();
        assert!(value(&proved, "certificate").starts_with("proved: "));
    }
}

#[test]
fn the_points_of_a_mesh_have_a_hull() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    shop.run("hull cube.csv -o cube.ply").stdout();
    let summary = shop.run("hull cube.ply").stdout();
    assert_eq!(value(&summary, "source"), "cube.ply, a mesh");
    assert_eq!(value(&summary, "facets"), "6");
    std::fs::write(shop.folder.path().join("bad.off"), "OFF\n1 0 0\n1 2 x\n").unwrap();
    let message = shop.run("hull bad.off").failure(3);
    assert!(
        message.starts_with("error: bad.off:3:5: \"x\" where a coordinate is expected"),
        "{message}"
    );
}
