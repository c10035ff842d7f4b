//! Commands on recorded runs: exit codes, forms, messages.

use crate::made_up::MadeUp;
use crate::workshop::Workshop;
use std::fs;

/// A folder with the runs `old`, `same` (other noise) and `slow` (one method slower by 30 %).
fn shop() -> Workshop {
    let shop = Workshop::new(&[]);
    let plan = |seed| MadeUp {
        sets: vec!["disc"],
        sizes: vec![1_000, 10_000],
        ..MadeUp::new(seed)
    };
    let mut slow = plan(3);
    slow.engines[1].1 *= 1.3;
    for (name, plan) in [("old", plan(1)), ("same", plan(2)), ("slow", slow)] {
        let folder = shop.folder.path().join(name);
        fs::create_dir(&folder).unwrap();
        plan.write(&folder);
    }
    shop
}

#[test]
fn diff_fails_for_the_slower_method_alone() {
    let shop = shop();
    let same = shop.run("diff old same").stdout();
    assert!(same.contains("0 of 8 cells have changed"), "{same}");
    let itself = shop.run("diff old old --format csv").stdout();
    assert!(
        itself.lines().skip(1).all(|line| line.ends_with(",none")),
        "{itself}"
    );
    let slow = shop.run("diff old slow");
    assert_eq!(slow.code, Some(1));
    assert!(slow.stdout.contains("| eddy ") && !slow.stdout.contains("| gs "));
    assert!(
        slow.stderr
            .starts_with("error: 2 of 8 cells are slower (eddy; "),
        "{slow:?}"
    );
}

#[test]
fn every_question_has_an_answer_in_every_form() {
    let shop = shop();
    for command in [
        "cmp old",
        "rank old",
        "fit old --time",
        "fit old --counter orient",
        "table old",
    ] {
        let text = shop.run(command).stdout();
        assert!(text.starts_with("# "), "{command}: {text}");
        let csv = shop.run(&format!("{command} --format csv")).stdout();
        assert!(csv.lines().count() > 1, "{command}: {csv}");
        let json = shop.run(&format!("{command} --format json")).stdout();
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert!(value.is_object() || value.is_array(), "{command}");
        shop.run(&format!("{command} -o out.md --force")).stdout();
        assert_eq!(shop.read("out.md"), text, "{command}");
    }
    for tool in ["github-action-benchmark", "bencher", "criterion"] {
        shop.run(&format!("export old --format {tool} -o {tool}.json"))
            .stdout();
        assert!(
            shop.read(&format!("{tool}.json"))
                .contains("made-up/disc/1000/gs")
        );
    }
    let names = shop.run("plot old --out drawings").stdout();
    assert_eq!(names.lines().count(), 3, "{names}");
    for name in names.lines() {
        assert!(shop.read(name).starts_with("<svg"), "{name}");
    }
}

#[test]
fn what_is_wrong_with_a_run_is_said() {
    let shop = shop();
    let message = shop.run("cmp nowhere").failure(4);
    assert!(message.contains("no such folder"), "{message}");
    let message = shop.run("fit old --counter pears").failure(2);
    assert!(message.contains("'pears'; there are orient"), "{message}");
    let message = shop.run("cmp old --baseline pears").failure(2);
    assert!(message.contains("eddy, graham, gs, qhull"), "{message}");
    assert_eq!(shop.run("fit old").code, Some(2));

    let path = shop.folder.path().join("old/samples.csv");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, format!("{text}made-up,disc,1000,0,gs,99,1,soon\n")).unwrap();
    let message = shop.run("rank old").failure(3);
    assert!(
        message.contains("samples.csv:") && message.contains("field nanoseconds"),
        "{message}"
    );
    fs::write(&path, format!("{text}made-up,disc,1000,0,gs,99,1,5")).unwrap();
    let torn = shop.run("rank old");
    assert_eq!(torn.code, Some(0));
    assert!(torn.stderr.contains("the last line has no end"), "{torn:?}");
}

#[test]
fn a_report_is_written_and_a_page_refreshed() {
    let shop = shop();
    let page = "# Times\n\n<!-- report:made-up -->\nold\n<!-- /report:made-up -->\n\nend\n";
    fs::write(shop.folder.path().join("README.md"), page).unwrap();
    let said = shop.run("report old -o report.html --splice README.md --baseline gs");
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(said.stderr.contains("README.md: 1 tables"), "{said:?}");
    let html = shop.read("report.html");
    assert!(html.starts_with("<!DOCTYPE html>") && html.ends_with("</html>\n"));
    let spliced = shop.read("README.md");
    assert!(!spliced.contains("old\n") && spliced.ends_with("<!-- /report:made-up -->\n\nend\n"));
    let rows = spliced
        .lines()
        .filter(|line| line.starts_with("| disc "))
        .count();
    assert_eq!(rows, 2, "{spliced}");
    shop.run("report old -o report.html --splice README.md --baseline gs");
    assert_eq!(shop.read("README.md"), spliced);

    fs::write(
        shop.folder.path().join("bad.md"),
        page.replace("made-up", "space"),
    )
    .unwrap();
    let message = shop.run("report old --splice bad.md").failure(3);
    assert!(
        message.contains("bad.md:3: the run has no definition 'space'"),
        "{message}"
    );
    assert!(!shop.folder.path().join("old/report.html").exists());
    let message = shop.run("report old --papers old").failure(3);
    assert!(
        message.contains("no folder in it has a claims.csv"),
        "{message}"
    );
    let message = shop.run("report old --counter pears").failure(2);
    assert!(message.contains("'pears'; there are orient"), "{message}");
}

#[test]
fn the_claims_are_read_from_the_reports() {
    let shop = Workshop::new(&[]);
    let reports = concat!(env!("CARGO_MANIFEST_DIR"), "/../reports");
    let text = shop.run(&format!("claims {reports} --format csv")).stdout();
    assert!(
        text.starts_with("claim,verdict,part,outcome,statistic"),
        "{text}"
    );
    for claim in ["GS-1", "D-3", "N-7", "B-2"] {
        assert!(text.contains(&format!("\n{claim},")), "{claim}");
    }
    let none = shop.run("claims .");
    assert_eq!(none.code, Some(3));
    assert!(none.stderr.contains("claims.csv"), "{none:?}");
}

#[test]
fn a_report_without_a_run_is_that_of_the_last_one() {
    let shop = Workshop::new(&[]);
    let none = shop.run("report");
    assert_eq!(none.code, Some(4));
    assert!(none.stderr.contains("no recorded run"), "{none:?}");
    let folder = shop.folder.path().join("runs/one");
    fs::create_dir_all(&folder).unwrap();
    MadeUp::new(1).write(&folder);
    assert_eq!(shop.run("report").code, Some(0));
    assert!(folder.join("report.html").is_file());
}
