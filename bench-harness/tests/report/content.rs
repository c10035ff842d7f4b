//! What stands in a report, and what must not.

use crate::markup::{fault, tags};
use crate::material::{page, run};
use bench_harness::analysis::cmp::cmp;
use bench_harness::report::matrix::ratios;

#[test]
fn a_report_is_well_formed_and_asks_nothing_of_anybody() {
    let page = page();
    assert_eq!(fault(&page), None);
    for tag in tags(&page) {
        assert!(!tag.starts_with("script"), "{tag}");
        for attribute in ["src=", "srcset=", "onload=", "onclick="] {
            assert!(!tag.contains(attribute), "{tag}");
        }
        let address = tag.split_once("href=\"").map_or("", |(_, rest)| rest);
        assert!(!address.contains("//"), "{tag}");
    }
    assert!(!page.contains("url(") && !page.contains("@import"));
    assert!(page.contains("Content-Security-Policy"));
}

#[test]
fn every_section_is_there_with_its_command() {
    let page = page();
    let sections = [
        ("overview", "hullbench measure made-up"),
        ("papers", "hullbench reproduce"),
        ("side-by-side", "hullbench cmp RUN"),
        ("ranks", "hullbench rank RUN --definition made-up"),
        ("failures", "hullbench cmp RUN"),
        ("ratios", "hullbench plot RUN"),
        ("growth", "hullbench fit RUN --time"),
        ("counts", "hullbench fit RUN --counter orient"),
        ("memory", "hullbench table RUN --counter peak_bytes"),
        ("machine", "manifest.json"),
    ];
    for (id, command) in sections {
        assert!(page.contains(&format!("href=\"#{id}\"")), "{id}");
        let (_, section) = page.split_once(&format!("<section id=\"{id}\"")).expect(id);
        let (section, _) = section.split_once("</section>").expect(id);
        assert!(section.contains(command), "{id}: {command}");
    }
}

#[test]
fn what_the_run_says_stands_in_it() {
    let page = page();
    let expected = [
        "Which of these is fastest?",
        "jarvis-j1",
        "noisy: 1.2 times itself",
        "more rounds",
        "misses &lt;b&gt;2&lt;&#x2f;b&gt; extreme points &amp; more",
        "Someone (1979)",
        "<strong>REFUTED</strong>",
        "Table 1: times",
        "A/A band",
        "n log n",
        "made up",
        "12.0",
    ];
    for text in expected {
        let plain = text.replace('/', "&#x2f;");
        assert!(page.contains(text) || page.contains(&plain), "{text}");
    }
}

#[test]
fn a_drawing_has_a_name_and_takes_the_colour_of_the_text() {
    let page = page();
    let drawings: Vec<&str> = tags(&page).filter(|tag| tag.starts_with("svg")).collect();
    assert!(drawings.len() >= 6, "{}", drawings.len());
    for drawing in drawings {
        assert!(drawing.contains("role=\"img\"") && drawing.contains("aria-label=\"made-up"));
    }
    assert!(!page.contains("#000000"));
}

#[test]
fn the_table_of_ratios_has_a_row_a_case_and_its_baseline_is_one() {
    let run = run();
    let table = ratios(&run, &cmp(&run, Some("gs")), "made-up").expect("a table");
    assert_eq!(table.rows.len(), 2 * 5);
    let place = |name: &str| {
        table
            .columns
            .iter()
            .position(|column| column == name)
            .expect(name)
    };
    for row in &table.rows {
        assert!(row[place("gs")].text.starts_with("1 (") && row[place("gs")].strong);
        let slower: f64 = row[place("qhull")].text.parse().expect("a ratio");
        assert!((2.5..4.0).contains(&slower), "{slower}");
    }
    assert!(ratios(&run, &cmp(&run, None), "other").is_none());
}
