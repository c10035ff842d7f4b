//! `hullbench delaunay`.

use crate::workshop::{SQUARE, Workshop, value};
use point_sets::mesh_file::read_mesh;
use serde_json::Value;

#[test]
fn delaunay_shows_a_summary() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let summary = shop.run("delaunay square.csv").stdout();
    assert_eq!(value(&summary, "points"), "7, of which 6 distinct");
    assert_eq!(value(&summary, "triangles"), "5");
    assert_eq!(value(&summary, "hull edges"), "5");
    assert!(
        value(&summary, "certificate").starts_with("proved: 5 triangles, none with a point inside")
    );
}

#[test]
fn triangles_are_written_in_every_format() {
    let shop = Workshop::new(&[]);
    let run = |output: &str| {
        shop.run(&format!("delaunay --set disc -n 60 {output}"))
            .stdout()
    };
    let csv = run("-o -");
    assert!(csv.starts_with("triangle,a,b,c\n0,"), "{csv}");
    let json: Value = serde_json::from_str(&run("--format json")).unwrap();
    assert_eq!(json["schema"], "hullbench/delaunay/1");
    let triangles = json["triangles"].as_array().unwrap();
    let hull = json["hull_edges"].as_array().unwrap().len();
    assert_eq!(triangles.len(), 2 * 60 - 2 - hull);
    assert_eq!(csv.lines().count(), triangles.len() + 1);
    for name in ["t.off", "t.obj", "t.ply"] {
        run(&format!("-o {name}"));
        let mesh = read_mesh(&shop.folder.path().join(name)).unwrap();
        assert_eq!(
            (mesh.points.len(), mesh.polygons.len()),
            (60, triangles.len())
        );
        assert_eq!(serde_json::json!(mesh.polygons), json["triangles"]);
    }
    let svg = run("--format svg");
    assert!(
        svg.starts_with("<svg ") && svg.ends_with("</svg>\n"),
        "{svg}"
    );
    assert_eq!(
        svg.matches('M').count(),
        json["edges"].as_u64().unwrap() as usize
    );
    assert_eq!(svg.matches("<circle").count(), 60);
    shop.run("delaunay --set disc -o t.stl").failure(2);
}

#[test]
fn far_from_the_origin_it_is_still_proved() {
    let shop = Workshop::new(&[]);
    for set in [
        "flattened-sphere:offset=1e7",
        "lattice",
        "collinear",
        "duplicated:of=disc",
    ] {
        let summary = shop.run(&format!("delaunay --set {set} -n 200")).stdout();
        assert!(
            value(&summary, "certificate").starts_with("proved: "),
            "{summary}"
        );
    }
    let message = shop.run("delaunay --set disc --method gs").failure(2);
    assert!(
        message.contains(
            "needs a delaunay method: fast-delaunay, fast-delaunay-parallel, lifted-delaunay"
        ),
        "{message}"
    );
    let message = shop.run("delaunay --set ball").failure(2);
    assert!(message.contains("ball is a set of space"), "{message}");
}
