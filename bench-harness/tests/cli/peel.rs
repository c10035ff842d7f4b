//! `hullbench peel`.

use crate::workshop::{SQUARE, Workshop, value};
use serde_json::Value;

#[test]
fn the_oblique_lattice_peels_as_published() {
    let shop = Workshop::new(&[]);
    let summary = shop
        .run("peel --set oblique:cols=10,rows=10 --boundary all")
        .stdout();
    assert_eq!(value(&summary, "layers"), "5");
    assert_eq!(value(&summary, "ring sizes"), "36, 28, 20, 12, 4");
    assert_eq!(value(&summary, "innermost"), "4 points");
    assert_eq!(
        value(&summary, "median"),
        "(18.0, 13.5), the mean of the innermost"
    );
}

#[test]
fn peel_ranks_every_point_in_the_order_of_the_file() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    shop.run("peel square.csv --boundary all -o ranks.csv")
        .stdout();
    assert_eq!(
        shop.read("ranks.csv"),
        "index,line,x,y,layer,c_rank,mid_rank\n\
         0,2,0.0,0.0,1,1,3.5\n\
         1,3,2.0,0.0,1,1,3.5\n\
         2,4,1.0,1.0,2,2,7.0\n\
         3,5,2.0,2.0,1,1,3.5\n\
         4,6,1.0,0.0,1,1,3.5\n\
         5,7,0.0,2.0,1,1,3.5\n\
         6,8,0.0,0.0,1,1,3.5\n"
    );
}

#[test]
fn both_peel_methods_agree() {
    let shop = Workshop::new(&[]);
    let ranks = |slug: &str| {
        shop.run(&format!("peel --set normal -n 200 --method {slug} -o -"))
            .stdout()
    };
    assert_eq!(ranks("gs-peel"), ranks("chain-peel"));
}

#[test]
fn peel_writes_json() {
    let shop = Workshop::new(&[("square.csv", SQUARE)]);
    let json = shop.run("peel square.csv --format json").stdout();
    let json: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["schema"], "hullbench/peel/1");
    assert_eq!(json["rings"][0], 4);
    assert_eq!(json["ranks"].as_array().unwrap().len(), 7);
}
