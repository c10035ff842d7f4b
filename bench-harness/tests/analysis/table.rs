//! `table`: layouts of papers.

use crate::made_up::MadeUp;
use bench_harness::analysis::table::table;
use bench_harness::output::target::{Format, Report};

#[test]
fn a_row_has_its_h_and_its_least_in_bold() {
    let page = table(&MadeUp::new(4).run(), &["orient".to_owned()]).page();
    assert_eq!(page.sections.len(), 4);
    let text = page.markdown();
    assert!(text.contains("## made-up/disc: nanoseconds"), "{text}");
    let row = text
        .lines()
        .find(|line| line.starts_with("| 1000 "))
        .expect("a row");
    let cells: Vec<&str> = row.split('|').map(str::trim).collect();
    // n, h, then the engines in order: eddy, graham, gs, qhull.
    assert!(cells[2].starts_with(['2', '3']), "{row}");
    assert!(
        cells[5].starts_with("**") && !cells[3].starts_with("**"),
        "{row}"
    );
}

#[test]
fn every_form_is_written() {
    let page = table(&MadeUp::new(4).run(), &[]).page();
    let written = |format: Format| {
        let mut out = Vec::new();
        page.write(&mut out, format).expect("written");
        String::from_utf8(out).expect("text")
    };
    assert!(written(Format::Latex).contains("\\textbf{"));
    assert_eq!(written(Format::Csv).lines().count(), 1 + 2 * 3 * 4);
    let json: serde_json::Value = serde_json::from_str(&written(Format::Json)).expect("json");
    assert!(json[0]["rows"][0]["values"]["gs"].as_f64().expect("a time") > 0.0);
}
