//! On which machine, by which method.

use crate::records::manifest::Cache;
use crate::report::Material;
use crate::report::document::{Part, Section, Table};

/// What was done, for a reader of this file alone.
const METHOD: [&str; 8] = [
    "Every engine is a process of its own and answers the same pipe protocol; points are handed over and converted while \
     no clock runs.",
    "A call goes from points in memory to the result in memory. Its checks of the input are timed; reading, converting and looking up indices are not.",
    "Each result is compared with a hull that an independent checker has proved; one that differs is checked itself. Only \
     certified cells are timed.",
    "A round takes one sample of every engine in an order shuffled anew, so that what disturbs the machine disturbs all.",
    "A realisation of small n is a batch of sets that are called in turn. A sample is as many passes as last two milliseconds \
     or more; times are those of one call.",
    "Ratios are of samples of the same round; intervals come from a bootstrap of realisations and of rounds within them.",
    "One engine is measured twice, under two names: the A/A band is how much a program differs from itself.",
    "Counts come from runs of their own, which are not timed.",
];

pub(in crate::report) fn section(material: &Material<'_>) -> Section {
    let mut parts = vec![
        Part::Table(machine(material)),
        Part::Table(engines(material)),
    ];
    parts.push(Part::heading("Method"));
    parts.push(Part::Notes {
        items: METHOD.map(str::to_owned).to_vec(),
    });
    parts.push(Part::text(
        "The whole method, what biases it and what is missing: METHODOLOGY.md, BIAS.md, MODELS.md, PROTOCOL.md and \
         WANTED.md in the folder bench-harness of the sources.",
    ));
    if !material.run.notes.is_empty() {
        let items = material.run.notes.clone();
        parts.push(Part::heading("Notes on the records"));
        parts.push(Part::Notes { items });
    }
    let folder = match material.run.folder.to_string_lossy() {
        folder if folder.is_empty() => "RUN".into(),
        folder => folder,
    };
    Section {
        id: "machine".into(),
        heading: "Machine and method".into(),
        commands: vec![format!("cat {folder}/manifest.json")],
        parts,
    }
}

fn machine(material: &Material<'_>) -> Table {
    let manifest = &material.run.manifest;
    let mut table = Table::new("Machine", &["what", "value"]);
    let load = |load: Option<[f64; 3]>| {
        load.map_or_else(String::new, |load| {
            load.map(|part| part.to_string()).join(" ")
        })
    };
    let cores = (manifest.cores > 0).then(|| manifest.cores.to_string());
    let memory = (manifest.memory > 0)
        .then(|| format!("{:.1} GiB", manifest.memory as f64 / f64::from(1 << 30)));
    let dirty = match manifest.dirty {
        true => " and changes that are not in it",
        false => "",
    };
    let commit = match manifest.commit.as_str() {
        "" => String::new(),
        commit => format!("{commit}{dirty}"),
    };
    let definitions = manifest.definitions.iter();
    let definitions: Vec<String> = definitions
        .map(|stamp| format!("{} (SHA-256 {})", stamp.id, stamp.sha256))
        .collect();
    let known = [
        ("processor", manifest.processor.clone()),
        ("cores", cores.unwrap_or_default()),
        ("memory", memory.unwrap_or_default()),
        ("data caches", caches(&manifest.caches)),
        ("kernel", manifest.kernel.clone()),
        (
            "frequency governor",
            manifest.governor.clone().unwrap_or_default(),
        ),
        ("load before (1, 5, 15 min)", load(manifest.load_before)),
        ("load after", load(manifest.load_after)),
        ("compiler", manifest.compiler.clone()),
        ("build", manifest.flags.clone()),
        ("commit", commit),
        ("started", manifest.started.clone()),
        ("definitions", definitions.join("; ")),
    ];
    for (what, value) in &known {
        if !value.is_empty() {
            table.push(&[what, value]);
        }
    }
    // Values here are no column of numbers.
    for entry in table.rows.iter_mut().flatten() {
        entry.number = false;
    }
    table
}

fn caches(caches: &[Cache]) -> String {
    let shown = caches.iter().map(|cache| match cache.bytes >> 10 {
        kib if kib >= 1024 => format!("L{} {} MiB", cache.level, kib >> 10),
        kib => format!("L{} {kib} KiB", cache.level),
    });
    shown.collect::<Vec<_>>().join(", ")
}

fn engines(material: &Material<'_>) -> Table {
    let mut table = Table::new("Engines", &["engine", "version", "clock, ns"]);
    for stamp in &material.run.manifest.engines {
        table.push(&[&stamp.name, &stamp.version, &stamp.clock_ns.to_string()]);
    }
    for row in &mut table.rows {
        row[1].number = false;
    }
    table
}
