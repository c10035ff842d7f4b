//! `hullbench hull`.

use crate::workshop::{Outcome, SQUARE, Workshop, value};
use serde_json::Value;

#[test]
fn hull_shows_a_summary() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let summary = shop.run("hull square.csv").stdout();
    assert_eq!(value(&summary, "points"), "7, of which 6 distinct");
    assert!(value(&summary, "method").starts_with("fast-2d, "));
    assert_eq!(value(&summary, "dimension"), "2");
    assert_eq!(value(&summary, "vertices"), "4");
    assert_eq!(value(&summary, "area"), "4.0");
    assert_eq!(value(&summary, "perimeter"), "8.0");
    assert_eq!(
        value(&summary, "certificate"),
        "proved: 4 vertices + 1 copies of them + 1 on edges + 1 inside = 7 points"
    );
    assert!(summary.contains("field 2 (x)"), "{summary}");
}

#[test]
fn hull_writes_csv_with_the_lines_of_the_file() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let outcome = shop.run("hull square.csv --boundary all -o hull.csv");
    assert_eq!(outcome.stdout, "");
    assert!(outcome.stderr.starts_with("hull.csv: 5 vertices"));
    assert_eq!(
        shop.read("hull.csv"),
        "order,index,line,x,y\n0,0,2,0.0,0.0\n1,4,6,1.0,0.0\n2,1,3,2.0,0.0\n3,3,5,2.0,2.0\n4,5,7,0.0,2.0\n"
    );
}

#[test]
fn hull_writes_json() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    shop.run("hull square.csv -o hull.json").stdout();
    let json: Value = serde_json::from_str(&shop.read("hull.json")).unwrap();
    assert_eq!(json["schema"], "hullbench/hull/1");
    assert_eq!(json["points"], 7);
    assert_eq!(json["certificate"]["inside"], 1);
    let indices: Vec<_> = json["vertices"]
        .as_array()
        .unwrap()
        .iter()
        .map(|vertex| vertex["index"].as_u64().unwrap())
        .collect();
    assert_eq!(indices, [0, 1, 3, 5]);
}

#[test]
fn standard_output_takes_either_format() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let csv = shop.run("hull square.csv -o -").stdout();
    assert!(csv.starts_with("order,index,line,x,y\n"), "{csv}");
    let json = shop.run("hull square.csv --format json").stdout();
    assert!(serde_json::from_str::<Value>(&json).is_ok(), "{json}");
    assert_eq!(
        shop.run("hull square.csv -o - --format json").stdout(),
        json
    );
    assert_eq!(shop.names(), ["square.csv"]);
}

#[test]
fn every_hull_method_gives_the_same_hull() {
    let shop = Workshop::new(&[]);
    let listed = shop.run("methods --format json").stdout();
    let listed: Value = serde_json::from_str(&listed).unwrap();
    let hulls: Vec<_> = listed
        .as_array()
        .unwrap()
        .iter()
        .filter(|method| method["computes"] == "hull")
        .map(|method| method["slug"].as_str().unwrap())
        .map(|slug| shop.run(&format!("hull --set disc -n 300 -o - --method {slug}")))
        .map(Outcome::stdout)
        .collect();
    assert!(hulls.len() >= 2);
    assert!(hulls.iter().all(|hull| *hull == hulls[0]));
}

#[test]
fn degenerate_points_have_a_hull() {
    let shop = Workshop::new(&[
        ("row.csv", "x,y\n0,0\n2,2\n1,1\n"),
        ("one.csv", "x,y\n1e300,5e-324\n"),
    ]);
    let row = shop.run("hull row.csv").stdout();
    assert_eq!(value(&row, "dimension"), "1: all points are on one line");
    assert_eq!(value(&row, "vertices"), "2");
    let one = shop.run("hull one.csv -o -").stdout();
    assert_eq!(one, "order,index,line,x,y\n0,0,2,1e300,5e-324\n");
}

#[test]
fn columns_are_taken_by_name_and_by_number() {
    let shop = Workshop::new(&[("t.csv", "a,b,c\n0,0,5\n1,0,5\n0,1,6\n")]);
    let by_name = shop.run("hull t.csv --columns a,c -o -").stdout();
    let by_number = shop.run("hull t.csv --columns 1,3 -o -").stdout();
    assert_eq!(by_name, by_number);
    assert!(by_name.contains(",0.0,6.0"), "{by_name}");
    let message = shop.run("hull t.csv --columns a,d").failure(3);
    assert!(message.contains("\"d\""), "{message}");
}

#[test]
fn an_area_that_overflows_is_null_in_json() {
    let shop = Workshop::new(&[("far.csv", "x,y\n0,0\n1e300,0\n0,1e300\n-0,0\n")]);
    let json = shop.run("hull far.csv --format json").stdout();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert!(json["area"].is_null());
    assert_eq!(json["distinct"], 3);
    assert_eq!(json["vertices"].as_array().unwrap().len(), 3);
}

#[test]
fn every_real_set_has_a_certified_hull_and_certified_layers() {
    let shop = Workshop::new(&[]);
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../data/points");
    let mut sets = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "csv") {
            continue;
        }
        sets += 1;
        for command in ["hull --dimension 2", "peel"] {
            let summary = shop.run_on(command, &path).stdout();
            assert!(value(&summary, "certificate").starts_with("proved: "));
        }
    }
    assert!(sets > 0);
}
