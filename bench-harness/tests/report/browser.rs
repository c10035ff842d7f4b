//! A headless Chromium opens the report from disk, and has nothing to say about it.

#![expect(clippy::print_stdout, reason = "a test that is skipped says so")]

use crate::material::page;
use std::fs;
use std::path::Path;
use std::process::Command;

const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// What the browser made of a page.
struct Opened {
    /// The page as it stands after loading.
    dom: String,
    /// What it said on its console.
    complaints: Vec<String>,
    /// The addresses that it asked for.
    requests: Vec<String>,
}

fn browser() -> Option<&'static str> {
    let starts = |name: &&&str| {
        let version = Command::new(name).arg("--version").output();
        version.is_ok_and(|output| output.status.success())
    };
    BROWSERS.iter().find(starts).copied()
}

/// Opens `page` from a file in `folder`.
fn open(browser: &str, folder: &Path, page: &str) -> Opened {
    let file = folder.join("report.html");
    let log = folder.join("net.json");
    fs::write(&file, page).expect("written");
    let output = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-background-networking",
            "--disable-component-update",
            "--no-first-run",
            "--enable-logging=stderr",
            "--v=0",
            "--virtual-time-budget=2000",
            "--dump-dom",
        ])
        .arg(format!(
            "--user-data-dir={}",
            folder.join("profile").display()
        ))
        .arg(format!("--log-net-log={}", log.display()))
        .arg(format!("file://{}", file.display()))
        .output()
        .expect("the browser starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Opened {
        dom: String::from_utf8_lossy(&output.stdout).into_owned(),
        complaints: said
            .lines()
            .filter(|line| line.contains("CONSOLE"))
            .map(str::to_owned)
            .collect(),
        requests: requests(&log),
    }
}

/// The addresses that the page asked for, by the browser's log of the network. What the browser asks of its own accord
/// has no origin.
fn requests(log: &Path) -> Vec<String> {
    let text = fs::read_to_string(log).expect("a log of the network");
    let log: serde_json::Value = serde_json::from_str(&text).expect("a whole log");
    let events = log["events"].as_array().expect("events");
    let asked = events.iter().filter_map(|event| {
        let params = &event["params"];
        let of_page = params["initiator"].as_str()? != "not an origin";
        let url = params["url"].as_str()?;
        (of_page && !url.starts_with("file:")).then(|| url.to_owned())
    });
    asked.collect()
}

#[test]
fn the_report_opens_without_a_complaint_or_a_request() {
    let Some(browser) = browser() else {
        println!("skipped: no browser ({} not found)", BROWSERS.join(", "));
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let opened = open(browser, folder.path(), &page());
    assert!(opened.dom.contains("id=\"machine-heading\""), "not loaded");
    assert_eq!(opened.complaints, [""; 0]);
    assert_eq!(opened.requests, [""; 0]);
}

#[test]
fn a_page_that_complains_or_asks_is_caught() {
    let Some(browser) = browser() else {
        println!("skipped: no browser ({} not found)", BROWSERS.join(", "));
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let bad = "<!DOCTYPE html><p id=\"machine-heading\">a</p>\
               <img src=\"http://elsewhere.invalid/a.png\"><script>console.error('no')</script>";
    let opened = open(browser, folder.path(), bad);
    assert!(!opened.complaints.is_empty());
    assert_eq!(opened.requests, ["http://elsewhere.invalid/a.png"]);
    // The report's own policy keeps the same page from asking.
    let folder = tempfile::tempdir().expect("a folder");
    let spoiled = page().replace(
        "<main",
        "<img src=\"http://elsewhere.invalid/a.png\" alt=\"\"><main",
    );
    let opened = open(browser, folder.path(), &spoiled);
    assert!(
        opened
            .complaints
            .iter()
            .any(|line| line.contains("Content Security Policy"))
    );
    assert_eq!(opened.requests, [""; 0]);
}
