//! Holds the arrows of ARCHITECTURE.md:
//!
//! ```text
//! geometry-core <- {point-sets, hull-verify, the families} <- hullkit <- bench-harness
//! ```
//!
//! and what the layers promise beyond Cargo's graph: the checker asks no kernel, and algorithms know nothing of
//! files, clocks, the environment or global randomness.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const FAMILIES: [&str; 6] = [
    "planar-peeling",
    "quickhull",
    "gift-wrap",
    "incremental",
    "divide-and-conquer",
    "lifted-delaunay",
];

type Arrows = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("the harness lies in the workspace")
        .to_owned()
}

/// The dependencies of each workspace crate on others of the workspace, of one kind (`None`: ordinary).
fn arrows(kind: Option<&str>) -> Arrows {
    let output = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--no-deps",
            "--format-version",
            "1",
            "--offline",
        ])
        .current_dir(root())
        .output()
        .expect("cargo metadata runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let metadata: Value =
        serde_json::from_slice(&output.stdout).expect("cargo metadata prints JSON");
    let packages = metadata["packages"]
        .as_array()
        .expect("packages is an array");
    let name = |package: &Value| {
        package["name"]
            .as_str()
            .expect("a package has a name")
            .to_owned()
    };
    let ours: BTreeSet<String> = packages.iter().map(name).collect();
    packages
        .iter()
        .map(|package| {
            let dependencies = package["dependencies"]
                .as_array()
                .expect("dependencies is an array");
            let of_kind = dependencies.iter().filter(|d| d["kind"].as_str() == kind);
            let targets = of_kind
                .map(name)
                .filter(|target| ours.contains(target))
                .collect();
            (name(package), targets)
        })
        .collect()
}

fn set(names: &[&str]) -> BTreeSet<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

#[test]
fn arrows_point_one_way() {
    for (source, targets) in arrows(None) {
        let allowed = match source.as_str() {
            "geometry-core" => set(&[]),
            "point-sets" | "hull-verify" => set(&["geometry-core"]),
            family if FAMILIES.contains(&family) => set(&["geometry-core"]),
            "hullkit" => set(&FAMILIES)
                .into_iter()
                .chain(set(&["geometry-core"]))
                .collect(),
            "bench-harness" => continue,
            other => {
                panic!("{other} is not in the architecture: place it here and in ARCHITECTURE.md")
            }
        };
        let extra: Vec<_> = targets.difference(&allowed).collect();
        assert!(extra.is_empty(), "{source} must not depend on {extra:?}");
    }
}

#[test]
fn tests_may_also_use_the_checker_and_the_point_sets() {
    for (source, targets) in arrows(Some("dev")) {
        if source == "bench-harness" {
            continue;
        }
        let extra: Vec<_> = targets
            .difference(&set(&["geometry-core", "hull-verify", "point-sets"]))
            .cloned()
            .collect();
        assert!(
            extra.is_empty(),
            "the tests of {source} must not depend on {extra:?}"
        );
    }
}

/// Every Rust source below `folder`.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.expect("a readable folder").path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found
}

/// Fails if a line of code (not a comment) of `path` holds one of `words`.
fn assert_free_of(path: &Path, words: &[&str]) {
    let text =
        fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    for (number, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or("");
        for word in words {
            assert!(
                !code.contains(word),
                "{}:{}: uses {word}",
                path.display(),
                number + 1
            );
        }
    }
}

#[test]
fn algorithms_know_nothing_of_the_world() {
    for family in FAMILIES.iter().chain(&["geometry-core"]) {
        for source in sources(&root().join("crates").join(family).join("src")) {
            assert_free_of(
                &source,
                &[
                    "std::fs",
                    "std::env",
                    "std::time",
                    "std::process",
                    "rand::rng(",
                ],
            );
        }
    }
}

#[test]
fn the_checker_asks_no_kernel() {
    let checker = root().join("crates/hull-verify/src");
    for source in sources(&checker) {
        let conformance = source
            .strip_prefix(&checker)
            .is_ok_and(|p| p.starts_with("conformance"));
        // Without one of these types there is no kernel to ask.
        // The conformance suite runs the methods, so it hands kernels to them; nothing else may name one.
        if !conformance && !source.ends_with("conformance.rs") {
            assert_free_of(
                &source,
                &[
                    "Kernel2",
                    "Kernel3",
                    "Exact",
                    "Tolerance",
                    "geometry_core::kernel",
                ],
            );
        }
    }
}

#[test]
fn every_method_is_registered_once_under_a_plain_slug() {
    let mut seen = BTreeSet::new();
    for method in hullkit::methods() {
        assert!(
            seen.insert(method.slug),
            "{} is registered twice",
            method.slug
        );
        let plain = method
            .slug
            .chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        assert!(plain, "{} is not a plain slug", method.slug);
        for text in [method.title, method.citation, method.cost] {
            assert!(
                !text.is_empty(),
                "{} lacks a title, a citation or a cost",
                method.slug
            );
        }
    }
}
