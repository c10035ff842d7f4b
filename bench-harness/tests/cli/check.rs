//! `hullbench check`.

use crate::workshop::{CUBE, SQUARE, Workshop, value};

#[test]
fn what_hull_writes_is_proved() {
    let shop = Workshop::new(&[("square.csv", SQUARE), ("cube.csv", CUBE)]);
    for hull in [
        "square.csv -o s.csv",
        "square.csv -o s.json",
        "cube.csv -o c.off",
        "cube.csv -o c.obj",
        "cube.csv -o c.ply",
        "cube.csv -o c.json",
    ] {
        shop.run(&format!("hull {hull}")).stdout();
        let (points, hull) = hull.split_once(" -o ").unwrap();
        let proved = shop.run(&format!("check {points} {hull}")).stdout();
        assert!(
            value(&proved, "certificate").starts_with("proved: "),
            "{proved}"
        );
    }
    shop.run("hull square.csv --boundary all -o all.csv")
        .stdout();
    shop.run("check square.csv all.csv --boundary all").stdout();
    assert_eq!(shop.run("check square.csv all.csv").code, Some(1));
}

#[test]
fn hulls_of_others_may_start_anywhere_and_name_copies() {
    let shop = Workshop::new(&[
        ("square.csv", SQUARE),
        ("scipy.txt", "3\n5\n6\n1\n"),
        ("head.csv", "# theirs\nname,Index\nd,3\nf,5\na,0\nb,1\n"),
        ("row.csv", "x,y\n2,2\n0,0\n1,1\n"),
        ("ends.txt", "0\n1\n"),
        ("all.txt", "0\n2\n1\n"),
    ]);
    shop.run("check square.csv scipy.txt").stdout();
    shop.run("check square.csv head.csv").stdout();
    shop.run("check row.csv ends.txt").stdout();
    shop.run("check row.csv all.txt --boundary all").stdout();
}

#[test]
fn facets_in_pieces_are_put_together() {
    let shop = Workshop::new(&[("cube.csv", CUBE)]);
    let corners: Vec<String> = CUBE
        .lines()
        .skip(1)
        .take(8)
        .map(|line| line.split(',').skip(1).collect::<Vec<_>>().join(" "))
        .collect();
    let triangles = "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n";
    let off = format!("3\n8 12 18\n{}\n{triangles}", corners.join("\n"));
    std::fs::write(shop.folder.path().join("qhull.off"), &off).unwrap();
    let proved = shop.run("check cube.csv qhull.off").stdout();
    assert_eq!(
        value(&proved, "facets"),
        "12 polygons of the file are 6 facets"
    );

    let open = off.replace("3 3 7 5\n", "").replace("8 12 18", "8 11 18");
    std::fs::write(shop.folder.path().join("open.off"), open).unwrap();
    let outcome = shop.run("check cube.csv open.off");
    assert_eq!(outcome.code, Some(1));
    assert!(
        outcome
            .stdout
            .contains("no facet has the reverse of the edge"),
        "{outcome:?}"
    );
    assert!(
        outcome
            .stderr
            .starts_with("error: open.off is not the hull of cube.csv: "),
        "{outcome:?}"
    );
}

#[test]
fn wrong_hulls_are_refused_with_what_is_wrong() {
    let shop = Workshop::new(&[
        ("square.csv", SQUARE),
        ("clockwise.txt", "0\n5\n3\n1\n"),
        ("missing.txt", "0\n1\n3\n"),
        ("beyond.txt", "0\n1\n99\n"),
        ("words.txt", "0\none\n"),
        ("cube.csv", CUBE),
        (
            "moved.off",
            "OFF\n4 4 0\n0 0 0\n2 0 0\n0 2 0\n0 0 2.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        ),
        (
            "small.off",
            "OFF\n4 4 0\n0 0 0\n2 0 0\n0 2 0\n0 0 2\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        ),
    ]);
    for (points, hull, finding) in [
        ("square.csv", "clockwise.txt", ""),
        ("square.csv", "missing.txt", "point 5 "),
        ("square.csv", "beyond.txt", "99"),
        (
            "cube.csv",
            "moved.off",
            "vertex 3 of the file, (0.0, 0.0, 2.5), is none of the points",
        ),
        ("cube.csv", "small.off", "lies outside facet"),
    ] {
        let outcome = shop.run(&format!("check {points} {hull}"));
        assert_eq!(outcome.code, Some(1), "{outcome:?}");
        assert!(outcome.stdout.contains(finding), "{outcome:?}");
        assert!(outcome.stderr.contains("is not the hull of"), "{outcome:?}");
    }
    let message = shop.run("check square.csv words.txt").failure(3);
    assert!(
        message.starts_with("error: words.txt:2: \"one\" is no index; "),
        "{message}"
    );
    shop.run("check square.csv nowhere.csv").failure(4);
    shop.run("check cube.csv square.csv").failure(3);
}
