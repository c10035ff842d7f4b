//! The resolution of the clock, and the peak of memory.

use std::fs;
use std::time::{Duration, Instant};

/// The smallest step of the clock that was seen, in nanoseconds: no sample is finer.
pub fn clock_resolution() -> u64 {
    const STEPS: usize = 1000;
    let step = || {
        let start = Instant::now();
        loop {
            let step = start.elapsed();
            if step > Duration::ZERO {
                return step;
            }
        }
    };
    let smallest = (0..STEPS).map(|_| step()).min();
    smallest.map_or(0, |step| step.as_nanos() as u64)
}

/// How far the resident memory of this process rises, in whole pages, without those of files, such as its own code.
///
/// Asks the operating system, so it costs nothing while the clock runs and is the same measure for a program in any
/// language. Memory that was freed before and is used again does not count as a rise: trust the first call of a
/// process only.
#[derive(Debug)]
pub struct Peak {
    before: u64,
}

impl Peak {
    /// Begins; `None` where the operating system does not tell (it is Linux that does).
    pub fn begin() -> Option<Self> {
        // Sets the peak back to what is resident now.
        fs::write("/proc/self/clear_refs", "5").ok()?;
        Some(Self {
            before: without_files("VmRSS:")?,
        })
    }

    /// The rise since, in bytes.
    pub fn bytes(&self) -> Option<u64> {
        Some(without_files("VmHWM:")?.saturating_sub(self.before))
    }
}

/// A size of resident memory without the pages of files that are resident now.
fn without_files(label: &str) -> Option<u64> {
    Some(status(label)?.saturating_sub(status("RssFile:")?))
}

/// A size from `/proc/self/status`, in bytes.
fn status(label: &str) -> Option<u64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(label))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_has_a_resolution_below_a_tenth_of_a_second() {
        let step = clock_resolution();
        assert!(step > 0 && step < 100_000_000, "{step}");
    }
}
