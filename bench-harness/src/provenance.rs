//! What a reader needs to judge a run and to run it again: the head of every file, the manifest of a run.

use crate::records::Manifest;
use crate::records::manifest::Cache;
use std::fs;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

/// Where a report comes from.
#[derive(Clone, Debug)]
pub(crate) struct Provenance {
    entries: Vec<(&'static str, String)>,
}

impl Provenance {
    /// Describes this run, this machine and this build; `None` for the seed where definitions name their own.
    pub(crate) fn collect(command: String, seed: Option<u64>) -> Self {
        let seed = seed.map_or_else(|| "the definitions'".to_owned(), |seed| seed.to_string());
        let entries = vec![
            ("command", command),
            ("seed", seed),
            ("commit", commit()),
            ("machine", machine()),
            ("kernel", first_line("/proc/sys/kernel/osrelease")),
            ("load before", first_line("/proc/loadavg")),
            ("compiler", output("rustc", &["--version"])),
            ("build", build().to_owned()),
            ("date", now()),
        ];
        Self { entries }
    }

    /// Adds what is known only at the end.
    pub(crate) fn finish(&mut self, seconds: u64) {
        self.entries
            .push(("load after", first_line("/proc/loadavg")));
        self.entries
            .push(("took", format!("{} min {} s", seconds / 60, seconds % 60)));
    }

    /// As lines, each starting with `mark`.
    pub(crate) fn comment(&self, mark: &str) -> String {
        let line = |(key, value): &(&str, String)| format!("{mark}{key}: {value}\n");
        self.entries.iter().map(line).collect()
    }

    /// As a Markdown block.
    pub(crate) fn markdown(&self) -> String {
        format!("```text\n{}```\n", self.comment(""))
    }
}

/// The manifest of a run that starts now.
pub(crate) fn manifest(command: &str) -> Manifest {
    let cpu = "/sys/devices/system/cpu/cpu0";
    let governor = fs::read_to_string(format!("{cpu}/cpufreq/scaling_governor"));
    let kilobytes = field("/proc/meminfo", "MemTotal");
    let kilobytes = kilobytes.split_whitespace().next();
    Manifest {
        commit: output("git", &["rev-parse", "HEAD"]),
        dirty: is_changed(),
        compiler: output("rustc", &["--version"]),
        flags: format!("{}, {}", build(), std::env::consts::ARCH),
        processor: processor(),
        cores: std::thread::available_parallelism().map_or(0, usize::from),
        memory: 1024
            * kilobytes
                .and_then(|text| text.parse::<u64>().ok())
                .unwrap_or(0),
        caches: caches(&format!("{cpu}/cache")),
        kernel: first_line("/proc/sys/kernel/osrelease"),
        governor: governor.ok().map(|text| text.trim().to_owned()),
        load_before: load(),
        load_after: None,
        command: command.to_owned(),
        started: now(),
        definitions: Vec::new(),
        engines: Vec::new(),
    }
}

/// The load averages over 1, 5 and 15 minutes.
pub(crate) fn load() -> Option<[f64; 3]> {
    let line = first_line("/proc/loadavg");
    let mut numbers = line.split_whitespace().map_while(|word| word.parse().ok());
    Some([numbers.next()?, numbers.next()?, numbers.next()?])
}

/// The data caches below `folder`, the smallest first.
fn caches(folder: &str) -> Vec<Cache> {
    let read = |name: String| fs::read_to_string(format!("{folder}/{name}"));
    let cache = |number: u32| {
        let part = |name: &str| read(format!("index{number}/{name}")).ok();
        let size = part("size")?;
        let bytes = match size.trim().split_at_checked(size.trim().len() - 1)? {
            (number, "K") => 1024 * number.parse::<u64>().ok()?,
            (number, "M") => 1024 * 1024 * number.parse::<u64>().ok()?,
            _ => return None,
        };
        let level = part("level")?.trim().parse().ok()?;
        (part("type")?.trim() != "Instruction").then_some(Cache { level, bytes })
    };
    (0..8).filter_map(cache).collect()
}

fn commit() -> String {
    let hash = output("git", &["rev-parse", "HEAD"]);
    if hash != "unknown" && is_changed() {
        format!("{hash} with uncommitted changes")
    } else {
        hash
    }
}

/// Whether the sources differ from the commit. A report being regenerated is a change too, so only the sources count.
fn is_changed() -> bool {
    let arguments = [
        "status",
        "--porcelain",
        "--untracked-files=no",
        "--",
        ".",
        ":!reports",
    ];
    !matches!(output("git", &arguments).as_str(), "" | "unknown")
}

fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    let memory = field("/proc/meminfo", "MemTotal");
    let (processor, architecture) = (processor(), std::env::consts::ARCH);
    format!("{processor}, {cores} cores, {memory} memory, {architecture}")
}

fn processor() -> String {
    let [name, family, model] =
        ["model name", "cpu family", "model\t"].map(|key| field("/proc/cpuinfo", key));
    format!("{name}, family {family} model {model}")
}

fn build() -> &'static str {
    if cfg!(debug_assertions) {
        "with assertions (times are not those of a release build)"
    } else {
        "release"
    }
}

/// The value of the first line of the form "key : value".
fn field(path: &str, key: &str) -> String {
    let text = fs::read_to_string(path).unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with(key));
    line.and_then(|line| line.split_once(':')).map_or_else(
        || "unknown".to_owned(),
        |(_, value)| value.trim().to_owned(),
    )
}

fn first_line(path: &str) -> String {
    let text = fs::read_to_string(path).unwrap_or_default();
    text.lines().next().unwrap_or("unknown").to_owned()
}

fn output(program: &str, arguments: &[&str]) -> String {
    let run = Command::new(program).args(arguments).output();
    match run {
        Ok(run) if run.status.success() => String::from_utf8_lossy(&run.stdout).trim().to_owned(),
        _ => "unknown".to_owned(),
    }
}

/// The time now, as RFC 3339 in UTC.
fn now() -> String {
    let seconds = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |since| since.as_secs());
    date(seconds)
}

/// Seconds since 1970 as a date, by the days of the Gregorian calendar counted from 1 March of year 0.
fn date(seconds: u64) -> String {
    let days = seconds / 86_400 + 719_468;
    let era = days / 146_097;
    let day_of_era = days % 146_097;
    let year_of_era =
        (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = if from_march < 10 {
        from_march + 3
    } else {
        from_march - 9
    };
    let year = year_of_era + era * 400 + u64::from(month <= 2);
    let (hour, minute, second) = (seconds / 3_600 % 24, seconds / 60 % 60, seconds % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_dates() {
        assert_eq!(date(0), "1970-01-01T00:00:00Z");
        assert_eq!(date(951_782_400), "2000-02-29T00:00:00Z");
        assert_eq!(date(1_795_000_000), "2026-11-18T11:06:40Z");
    }

    #[test]
    fn every_line_is_a_comment() {
        let provenance = Provenance::collect("hullbench reproduce".into(), Some(5));
        assert!(
            provenance
                .comment("# ")
                .lines()
                .all(|line| line.starts_with("# "))
        );
        assert!(
            provenance
                .markdown()
                .starts_with("```text\ncommand: hullbench reproduce\nseed: 5\n")
        );
    }
}
