//! A peer that misbehaves on purpose, for the tests of the harness: `fake-peer MODE [FILE]`.
//!
//! It is method `gs` behind the pipe protocol, but for one fault named by MODE. FILE, if given, receives its process id.

// Here the two streams are what the other end listens to.
#![allow(clippy::print_stdout, clippy::print_stderr)]

use bench_harness::engine::answer::Answer;
use bench_harness::engine::own::Own;
use bench_harness::engine::protocol::{Counters, Kind, Load, Receipt, Run, line};
use bench_harness::engine::server::{Engine, serve};
use std::io::{self, BufRead, Write};
use std::time::Duration;
use std::{env, fs, process, thread};

struct Fake {
    mode: String,
    honest: Own,
}

fn main() -> io::Result<()> {
    let mut arguments = env::args().skip(1);
    let mode = arguments.next().expect("a mode");
    if let Some(file) = arguments.next() {
        fs::write(file, process::id().to_string())?;
    }
    let mut input = io::stdin().lock();
    let mut output = io::stdout().lock();
    match &*mode {
        // Reads, and says nothing.
        "silent" => {
            for _ in input.lines() {}
            return Ok(());
        }
        // Says something else.
        "chatter" => {
            writeln!(output, "Hello! Ready when you are.")?;
            sleep_for_ever();
        }
        // Never comes to the end of a line.
        "flood" => loop {
            output.write_all(&[b'x'; 1 << 16])?;
        },
        // Ends at once.
        "quitter" => return Ok(()),
        _ => {}
    }
    let method = hullkit::method("gs").expect("a registered method");
    let honest = Own::new(method).expect("a method of the plane");
    let mut fake = Fake { mode, honest };
    if fake.mode == "deaf" {
        // Says who it is without being asked, and never reads.
        writeln!(output, "{}", line(&fake.receipt()))?;
        output.flush()?;
        sleep_for_ever();
    }
    serve(&mut fake, &mut input, &mut io::BufWriter::new(output))
}

fn sleep_for_ever() -> ! {
    loop {
        thread::sleep(Duration::from_secs(3600));
    }
}

impl Engine for Fake {
    fn receipt(&self) -> Receipt {
        let receipt = self.honest.receipt();
        Receipt {
            protocol: if self.mode == "future" {
                2
            } else {
                receipt.protocol
            },
            engine: if self.mode == "impostor" {
                "qhull"
            } else {
                "fake"
            }
            .to_owned(),
            ..receipt
        }
    }

    fn load(&mut self, load: &Load, coordinates: Vec<f64>) -> Result<(), String> {
        match &*self.mode {
            "picky" if load.n < 10 => Err("too few points".into()),
            "forgetful" => {
                println!(r#"{{"loaded":1}}"#);
                sleep_for_ever()
            }
            // Knows nothing of batches.
            "single" if load.sets.get() > 1 => {
                println!(r#"{{"loaded":{}}}"#, load.n);
                sleep_for_ever()
            }
            _ => self.honest.load(load, coordinates),
        }
    }

    fn run(&mut self, run: &Run) -> Result<Vec<u64>, String> {
        match &*self.mode {
            "hang" => sleep_for_ever(),
            "crash" => {
                eprintln!("about to fail");
                process::abort()
            }
            "exit" => {
                eprintln!("cannot go on");
                process::exit(3)
            }
            "mumble" => {
                print!(r#"{{"nanoseconds":[1"#);
                process::exit(0)
            }
            "slow" => {
                thread::sleep(Duration::from_millis(200));
                self.honest.run(run)
            }
            "boast" => Ok(vec![3_600_000_000_000; run.samples.get() as usize]),
            "stingy" => Ok(vec![]),
            _ => self.honest.run(run),
        }
    }

    fn hull(&mut self, set: u32) -> Result<Answer, String> {
        // Of every set it tells what it found for the first one.
        let set = if self.mode == "stale" { 0 } else { set };
        let answer = self.honest.hull(set)?;
        let mut vertices: Vec<u32> = answer.parts().flatten().copied().collect();
        match &*self.mode {
            // A hull, but not that of the points.
            "lie" => {
                vertices.pop();
                Ok(Answer::new(Kind::Cycle, [vertices]))
            }
            "stranger" => Ok(Answer::new(Kind::Cycle, [[0, 1, u32::MAX]])),
            "truncate" => {
                println!("{}", line(&answer.header()));
                io::stdout()
                    .write_all(&[0; 6])
                    .map_err(|error| error.to_string())?;
                process::exit(0)
            }
            "huge" => {
                println!(r#"{{"kind":"cycle","lengths":1,"indices":4000000000}}"#);
                sleep_for_ever()
            }
            "endless" => {
                println!(r#"{{"kind":"cycle","lengths":1,"indices":18446744073709551615}}"#);
                sleep_for_ever()
            }
            _ => Ok(answer),
        }
    }

    fn counters(&mut self) -> Result<Counters, String> {
        self.honest.counters()
    }
}
