//! What goes wrong: exit codes, messages, and what is not left behind.

use crate::workshop::{Outcome, SQUARE, Workshop, value};
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn a_bad_line_is_named_and_nothing_is_written() {
    let shop = Workshop::new(&[("bad.csv", "x,y\n1,2\n3,four\n5,6\n")]);
    for command in ["hull", "peel"] {
        let message = shop
            .run(&format!("{command} bad.csv -o out.csv"))
            .failure(3);
        assert!(message.starts_with("error: bad.csv:3:3: "), "{message}");
        assert_eq!(shop.names(), ["bad.csv"]);
    }
}

#[test]
fn a_coordinate_that_is_not_finite_is_bad_data() {
    let shop = Workshop::new(&[("inf.csv", "x,y\n1,2\ninf,4\n")]);
    let message = shop.run("hull inf.csv").failure(3);
    assert!(message.starts_with("error: inf.csv:3:1: "), "{message}");
}

#[test]
fn an_empty_file_is_bad_data() {
    let shop = Workshop::new(&[("empty.csv", "")]);
    let message = shop.run("hull empty.csv").failure(3);
    assert!(message.starts_with("error: empty.csv:1:1: "), "{message}");
}

#[test]
fn no_points_from_the_catalogue_have_an_empty_hull_and_no_layers() {
    let shop = Workshop::new(&[]);
    let hull = shop.run("hull --set disc -n 0 -o -").stdout();
    assert_eq!(hull, "order,index,line,x,y\n");
    let peel = shop.run("peel --set disc -n 0").stdout();
    assert_eq!(value(&peel, "layers"), "0");
}

#[test]
fn what_a_message_asks_for_can_be_said() {
    let shop = Workshop::new(&[
        ("t.csv", "town,7,z\na,1,2\nb,3,4\nc,0,9\n"),
        ("u.csv", "1990,2000\n1,5;2,5\n"),
    ]);
    let message = shop.run("hull t.csv").failure(3);
    assert!(message.contains("may be a header or a point"), "{message}");
    let summary = shop.run("hull t.csv --header present").stdout();
    assert_eq!(value(&summary, "points"), "3");
    let message = shop
        .run("hull u.csv --header present --separator comma")
        .failure(3);
    assert!(message.starts_with("error: u.csv:2:"), "{message}");
    let message = shop.run("hull u.csv --separator semicolon").failure(3);
    assert!(message.contains("\";\""), "{message}");
    assert_eq!(shop.run("hull --set disc --header absent").code, Some(2));
}

#[test]
fn a_missing_file_is_an_input_error() {
    let message = Workshop::new(&[]).run("hull nowhere.csv").failure(4);
    assert!(message.starts_with("error: nowhere.csv: "), "{message}");
}

#[test]
fn an_unknown_method_suggests_the_nearest() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let message = shop.run("hull square.csv --method gramham").failure(2);
    assert!(message.contains("did you mean 'graham'?"), "{message}");
    let message = shop.run("methods gs-peal").failure(2);
    assert!(message.contains("did you mean 'gs-peel'?"), "{message}");
    let message = shop.run("hull square.csv --method gs-peel").failure(2);
    assert!(message.contains("computes layers"), "{message}");
}

#[test]
fn an_unknown_point_set_is_a_usage_error() {
    let outcome = Workshop::new(&[]).run("hull --set disk");
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.stderr.contains("did you mean disc?"));
}

#[test]
fn a_size_without_a_set_is_a_usage_error() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    shop.run("hull square.csv -n 5").failure(2);
    assert_eq!(shop.run("hull").code, Some(2));
    assert_eq!(shop.run("hull square.csv --set disc").code, Some(2));
}

#[test]
fn an_existing_file_is_replaced_only_by_force() {
    let shop = Workshop::new(&[("square.csv", SQUARE), ("out.csv", "precious")]);
    for command in [
        "hull square.csv -o out.csv",
        "peel square.csv -o out.csv",
        "points disc -n 3 -o out.csv",
    ] {
        fs::write(shop.folder.path().join("out.csv"), "precious").unwrap();
        let message = shop.run(command).failure(4);
        assert!(message.contains("--force"), "{message}");
        assert_eq!(shop.read("out.csv"), "precious");
        shop.run(&format!("{command} --force")).stdout();
        assert!(shop.read("out.csv").contains("x,y"));
    }
    assert_eq!(shop.names(), ["out.csv", "square.csv"]);
}

#[test]
fn a_folder_that_does_not_exist_is_an_output_error() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let message = shop.run("hull square.csv -o no/hull.csv").failure(4);
    assert!(message.contains("create it first"), "{message}");
}

#[test]
fn an_extension_that_names_no_format_is_a_usage_error() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    shop.run("hull square.csv -o hull.txt").failure(2);
    shop.run("hull square.csv -o hull.txt --format csv")
        .stdout();
    assert_eq!(shop.names(), ["hull.txt", "square.csv"]);
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_hullbench"))
        .args(["points", "disc", "-n", "100000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 16];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    let outcome = Outcome::of(child.wait_with_output().unwrap());
    assert_eq!(outcome.code, Some(0), "{outcome:?}");
    assert_eq!(outcome.stderr, "");
}
