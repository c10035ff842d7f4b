//! `hullbench points`, `hullbench methods`, and the help.

use crate::workshop::{Workshop, value};
use serde_json::Value;

#[test]
fn generated_points_come_back_from_their_file_to_the_last_bit() {
    let shop = Workshop::new(&[]);
    shop.run("points cauchy -n 500 --seed 7 -o cauchy.csv")
        .stdout();
    let from_file = shop.run("hull cauchy.csv -o - --format json").stdout();
    let direct = shop
        .run("hull --set cauchy -n 500 --seed 7 --format json")
        .stdout();
    let [from_file, direct] =
        [from_file, direct].map(|json| serde_json::from_str::<Value>(&json).unwrap());
    for (read, drawn) in std::iter::zip(
        from_file["vertices"].as_array().unwrap(),
        direct["vertices"].as_array().unwrap(),
    ) {
        for member in ["index", "x", "y"] {
            assert_eq!(read[member], drawn[member]);
        }
        assert!(read["line"].is_u64() && drawn["line"].is_null());
    }
    assert_eq!(from_file["area"], direct["area"]);
}

#[test]
fn a_generated_file_says_how_to_make_it_again() {
    let shop = Workshop::new(&[]);
    let text = shop.run("points oblique:cols=3,rows=2").stdout();
    let head = text.lines().next().unwrap();
    assert!(head.starts_with("# oblique:cols=3,rows=2, n 6, seed "));
    assert!(head.contains("fingerprint "), "{head}");
    assert_eq!(
        text.lines().filter(|line| !line.starts_with('#')).count(),
        7
    );
}

#[test]
fn points_of_space_come_back_from_their_file_to_the_last_bit() {
    let shop = Workshop::new(&[]);
    shop.run("points shuffled:of=near-coplanar -n 200 -o near.csv")
        .stdout();
    let from_file = shop.run("hull near.csv -o - --format off").stdout();
    let direct = shop
        .run("hull --set shuffled:of=near-coplanar -n 200 --format off")
        .stdout();
    assert_eq!(from_file, direct);
    let text = shop
        .run("points cubic-lattice:cols=2,rows=2,layers=3")
        .stdout();
    assert!(text.contains("\nx,y,z\n0.0,0.0,0.0\n"), "{text}");
    assert_eq!(
        text.lines().filter(|line| !line.starts_with('#')).count(),
        13
    );
}

#[test]
fn the_catalogue_is_listed() {
    let list = Workshop::new(&[]).run("points --list").stdout();
    for entry in point_sets::catalogue() {
        assert!(
            list.lines().any(|line| line == entry.name),
            "{}",
            entry.name
        );
    }
}

#[test]
fn the_registry_is_listed() {
    let shop = Workshop::new(&[]);
    let table = shop.run("methods").stdout();
    let json: Value = serde_json::from_str(&shop.run("methods --format json").stdout()).unwrap();
    for (method, entry) in hullkit::methods().zip(json.as_array().unwrap()) {
        assert!(table.contains(method.slug), "{}", method.slug);
        assert_eq!(entry["slug"], method.slug);
        assert_eq!(entry["citation"], method.citation);
    }
    let entry = shop.run("methods gs").stdout();
    assert!(value(&entry, "citation").contains("1979"), "{entry}");
}

#[test]
fn every_help_shows_an_example_and_the_exit_codes() {
    let shop = Workshop::new(&[]);
    for command in [
        "",
        "hull ",
        "peel ",
        "delaunay ",
        "sweep ",
        "check ",
        "points ",
        "methods ",
        "engine ",
        "peers ",
        "peers build ",
        "peers list ",
        "reproduce ",
    ] {
        let help = shop.run(&format!("{command}--help")).stdout();
        assert!(help.contains("Examples:\n  hullbench "), "{command}");
        assert!(help.contains("Exit codes:"), "{command}");
    }
}
