//! `hullbench sweep`.

use crate::workshop::{CUBE, Workshop, value};
use serde_json::Value;

#[test]
fn obstacles_are_located_exactly() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    let summary = shop
        .run("sweep cube.csv --by 10,0,-0.5 --obstacle 6,1,1 --obstacle 6,0,1 --obstacle -1,1,1 --obstacle 12,1,1.5")
        .stdout();
    assert_eq!(value(&summary, "volume"), "50.0");
    assert_eq!(value(&summary, "rounding"), "the hull is the swept volume");
    let located: Vec<_> = summary
        .lines()
        .filter_map(|line| line.strip_prefix("obstacle"))
        .map(str::trim)
        .collect();
    assert_eq!(
        located,
        [
            "(6.0, 1.0, 1.0) inside",
            "(6.0, 0.0, 1.0) boundary",
            "(-1.0, 1.0, 1.0) outside",
            "(12.0, 1.0, 1.5) boundary"
        ]
    );
}

#[test]
fn the_swept_volume_is_written_as_a_hull_is() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    shop.run("hull cube.csv -o cube.off").stdout();
    shop.run("sweep cube.off --by 1,1,0 -o swept.obj").stdout();
    shop.run("sweep cube.off --by 1,1,0 --obstacle 5,5,5 -o swept.json")
        .stdout();
    let json: Value = serde_json::from_str(&shop.read("swept.json")).unwrap();
    assert_eq!(json["schema"], "hullbench/sweep/1");
    assert_eq!(json["exact"], true);
    assert_eq!(json["obstacles"][0]["location"], "outside");
    assert_eq!(json["hull"]["facets"].as_array().unwrap().len(), 8);
    let mesh = shop.run("hull swept.obj").stdout();
    assert_eq!(value(&mesh, "facets"), "8");
}

#[test]
fn moves_that_cannot_be_are_refused() {
    let shop = Workshop::new(&[("cube.csv", CUBE), ("far.csv", "1.5e308,0,0\n0,1,2\n")]);
    for by in ["1,2", "1,2,x", "1,2,inf"] {
        assert_eq!(
            shop.run(&format!("sweep cube.csv --by {by}")).code,
            Some(2),
            "{by}"
        );
    }
    assert_eq!(shop.run("sweep cube.csv").code, Some(2));
    let message = shop.run("sweep far.csv --by 1e308,0,0").failure(3);
    assert!(message.contains("must be finite"), "{message}");
}
