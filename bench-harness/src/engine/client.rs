//! The harness's end of the pipe: a child process, and a deadline on every reply.
//!
//! Three threads stand between the harness and a child: one writes, so that a child that does not read cannot hold us
//! up; one reads, so that waiting can end; one keeps the last of what the child complains of. All three end with their
//! pipes. A child that fails in any way but a refusal is killed and reaped at once, and so is one whose [`Session`] is
//! dropped.

use super::answer::Answer;
use super::fault::Fault;
use super::incoming::{Incoming, Stop};
use super::protocol::{
    Command, Convention, Counters, HullHeader, Load, Loaded, PROTOCOL, Problem, Receipt, Reply,
    Run, Samples, Which, line,
};
use crate::counting::PointSet;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::{BTreeMap, VecDeque};
use std::ffi::OsString;
use std::io::{Read, Write};
use std::num::NonZeroU32;
use std::path::PathBuf;
use std::process::{Child, ChildStderr, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How an engine is started.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Launch {
    /// The name that its receipt must show.
    pub engine: String,
    /// The program.
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<OsString>,
}

/// A conversation with a running engine.
#[derive(Debug)]
pub struct Session {
    child: Child,
    requests: Sender<Vec<u8>>,
    incoming: Incoming,
    complaints: Receiver<Vec<u8>>,
    receipt: Receipt,
    loaded: Option<Load>,
    /// What ended the conversation, if it has ended.
    fallen: Option<Fault>,
}

/// What `run` brought.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Timed {
    /// The wall time of each sample, as the engine measured it.
    pub nanoseconds: Vec<u64>,
    /// The time until the reply was here, as we measured it: never less than all samples together.
    pub elapsed: Duration,
}

impl Session {
    /// Starts an engine and asks for its receipt.
    ///
    /// # Errors
    ///
    /// [`Fault::Absent`] if it cannot be started; any other fault if the receipt does not come within `limit`, or is
    /// that of another engine or another protocol.
    pub fn start(launch: &Launch, limit: Duration) -> Result<Self, Fault> {
        let mut child = std::process::Command::new(&launch.program)
            .args(&launch.arguments)
            // Of a panic its message is wanted.
            .env("RUST_BACKTRACE", "0")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| Fault::Absent {
                missing: format!("{} cannot be started: {error}", launch.program.display()),
            })?;
        let (Some(stdin), Some(stdout), Some(stderr)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            unreachable!("all three were asked for")
        };
        let mut session = Self {
            child,
            requests: writer(stdin),
            incoming: Incoming::from(stdout),
            complaints: tail(stderr),
            receipt: Receipt {
                protocol: PROTOCOL,
                engine: launch.engine.clone(),
                version: String::new(),
                clock_ns: 0,
                tasks: Vec::new(),
                build: String::new(),
            },
            loaded: None,
            fallen: None,
        };
        session.receipt = session.ask(Command::Version, Vec::new(), limit)?;
        let expected = (PROTOCOL, &*launch.engine);
        let got = (session.receipt.protocol, &*session.receipt.engine);
        if got != expected {
            let [expected, got] = [expected, got]
                .map(|(protocol, engine)| format!("protocol {protocol} of engine '{engine}'"));
            return Err(session.fall(Fault::Garbled { expected, got }));
        }
        Ok(session)
    }

    /// The receipt: who computes.
    pub fn receipt(&self) -> &Receipt {
        &self.receipt
    }

    /// The number of its process.
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Hands over one set of points for `problem`.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`].
    pub fn load<const D: usize>(
        &mut self,
        problem: Problem,
        boundary: Convention,
        points: &[[f64; D]],
        limit: Duration,
    ) -> Result<(), Fault> {
        self.hand_over(problem, boundary, D, &[points.as_flattened()], limit)
    }

    /// Hands over sets of as many points each for `problem`; every pass of a run goes through all of them.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`]; [`Fault::Refused`] for no sets and for sets that differ in size or dimension.
    pub fn load_sets(
        &mut self,
        problem: Problem,
        boundary: Convention,
        sets: &[PointSet],
        limit: Duration,
    ) -> Result<(), Fault> {
        let dimension = sets.first().map_or(0, PointSet::dimension);
        if sets.iter().any(|set| set.dimension() != dimension) {
            self.loaded = None;
            return Err(refused("sets of different dimensions"));
        }
        let sets: Vec<&[f64]> = sets.iter().map(PointSet::coordinates).collect();
        self.hand_over(problem, boundary, dimension, &sets, limit)
    }

    fn hand_over(
        &mut self,
        problem: Problem,
        boundary: Convention,
        dimension: usize,
        sets: &[&[f64]],
        limit: Duration,
    ) -> Result<(), Fault> {
        self.loaded = None;
        let number = u32::try_from(sets.len()).ok().and_then(NonZeroU32::new);
        let (Some(first), Some(number)) = (sets.first(), number) else {
            return Err(refused("no sets, or too many"));
        };
        if dimension != problem.dimension() {
            let what = format!("{problem} is not about points of {dimension} coordinates");
            return Err(refused(&what));
        }
        if sets.iter().any(|set| set.len() != first.len()) {
            return Err(refused("sets of different sizes"));
        }
        if !self.receipt.tasks.contains(&problem) {
            let what = format!("{} does not do {problem}", self.receipt.engine);
            return Err(refused(&what));
        }
        let n = u32::try_from(first.len() / dimension).map_err(|_| refused("too many points"))?;
        let load = Load {
            task: problem,
            n,
            sets: number,
            dimension,
            boundary,
        };
        let mut raw = Vec::with_capacity(size_of_val(*first) * sets.len());
        for x in sets.iter().copied().flatten() {
            raw.extend_from_slice(&x.to_le_bytes());
        }
        let reply: Loaded = self.ask(Command::Load(load), raw, limit)?;
        let due = Loaded {
            loaded: n,
            sets: number,
        };
        if reply != due {
            return Err(self.fall(garbled(line(&due), line(&reply))));
        }
        self.loaded = Some(load);
        Ok(())
    }

    /// Takes samples.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`]. Samples that together took longer than it took to get them are garbled.
    pub fn run(&mut self, run: Run, limit: Duration) -> Result<Timed, Fault> {
        let start = Instant::now();
        let reply: Samples = self.ask(Command::Run(run), Vec::new(), limit)?;
        let elapsed = start.elapsed();
        let (came, due) = (reply.nanoseconds.len(), run.samples.get() as usize);
        if came != due {
            return Err(self.fall(garbled(format!("{due} samples"), format!("{came}"))));
        }
        let sum: u128 = reply.nanoseconds.iter().map(|&ns| u128::from(ns)).sum();
        if sum > elapsed.as_nanos() {
            let expected = format!("samples of no more than {elapsed:?} in all");
            return Err(self.fall(garbled(expected, format!("{sum} ns"))));
        }
        Ok(Timed {
            nanoseconds: reply.nanoseconds,
            elapsed,
        })
    }

    /// The hull of the first set, of the last run.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`].
    pub fn hull(&mut self, limit: Duration) -> Result<Answer, Fault> {
        self.hull_of(0, limit)
    }

    /// The hull of set number `set`, of the last pass of the last run.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`].
    pub fn hull_of(&mut self, set: u32, limit: Duration) -> Result<Answer, Fault> {
        let Some(load) = self.loaded else {
            let fallen = self.fallen.clone();
            return Err(fallen.unwrap_or_else(|| refused("no points were loaded")));
        };
        let deadline = Instant::now() + limit;
        let header: HullHeader = self.ask(Command::Hull(Which { set }), Vec::new(), limit)?;
        let count = header.lengths.saturating_add(header.indices);
        let bytes = count.saturating_mul(size_of::<u32>());
        let most = Answer::most_bytes(load.task, load.n);
        if bytes > most {
            let expected = format!("arrays of no more than {most} bytes");
            return Err(self.fall(garbled(expected, format!("{bytes}"))));
        }
        let arrays = self.incoming.exactly(bytes, deadline);
        let arrays = arrays.map_err(|stop| {
            let expected = format!("{bytes} bytes of a hull");
            self.stopped(stop, "hull", expected, limit)
        })?;
        Answer::read(header, &arrays, load.n)
            .map_err(|got| self.fall(garbled("arrays of a hull".into(), got)))
    }

    /// Whatever the engine counts.
    ///
    /// # Errors
    ///
    /// Any fault but [`Fault::Absent`].
    pub fn counters(&mut self, limit: Duration) -> Result<BTreeMap<String, u64>, Fault> {
        let reply: Counters = self.ask(Command::Counters, Vec::new(), limit)?;
        Ok(reply.counters)
    }

    /// Says good-bye, and waits for no longer than `limit` before it kills.
    pub fn quit(mut self, limit: Duration) {
        let _ = self.requests.send(b"quit\n".to_vec());
        self.ended_by(Instant::now() + limit);
    }

    /// Sends `command` and `raw`, and waits for the reply.
    fn ask<T: DeserializeOwned + Serialize>(
        &mut self,
        command: Command,
        raw: Vec<u8>,
        limit: Duration,
    ) -> Result<T, Fault> {
        if let Some(fault) = &self.fallen {
            return Err(fault.clone());
        }
        let deadline = Instant::now() + limit;
        // A writer that is gone has met a closed pipe: what there is to learn comes from the other one.
        let _ = self.requests.send(format!("{command}\n").into_bytes());
        let _ = self.requests.send(raw);
        let expected = || format!("a reply to '{}'", command.word());
        let reply = self.incoming.line(deadline);
        let reply = reply.map_err(|stop| self.stopped(stop, command.word(), expected(), limit))?;
        match serde_json::from_slice(&reply) {
            Ok(Reply::Done(done)) => Ok(done),
            Ok(Reply::Refused { refused }) => Err(Fault::Refused { reason: refused }),
            Err(_) => Err(self.fall(garbled(expected(), excerpt(&reply)))),
        }
    }

    /// The fault of a reply that did not come.
    fn stopped(
        &mut self,
        stop: Stop,
        command: &'static str,
        expected: String,
        limit: Duration,
    ) -> Fault {
        let fault = match stop {
            Stop::Late => Fault::Timeout { command, limit },
            Stop::Endless(begin) => garbled(expected, excerpt(&begin)),
            Stop::Ended(rest) => {
                // A pipe is closed a moment before its process has ended.
                const MOMENT: Duration = Duration::from_secs(2);
                match self.ended_by(Instant::now() + MOMENT) {
                    Some(status) if !status.success() => Fault::Crashed {
                        status: status.to_string(),
                        stderr: self.last_words(),
                    },
                    _ => garbled(expected, format!("the end after {}", excerpt(&rest))),
                }
            }
        };
        self.fall(fault)
    }

    /// Ends the conversation.
    fn fall(&mut self, fault: Fault) -> Fault {
        self.kill();
        self.fallen = Some(fault.clone());
        fault
    }

    /// How the child ended, if it does before the deadline.
    fn ended_by(&mut self, deadline: Instant) -> Option<std::process::ExitStatus> {
        const PAUSE: Duration = Duration::from_millis(2);
        loop {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Some(status);
            }
            if Instant::now() >= deadline {
                return None;
            }
            thread::sleep(PAUSE);
        }
    }

    /// The end of what the child wrote to standard error.
    fn last_words(&self) -> String {
        const PATIENCE: Duration = Duration::from_secs(1);
        let words = self.complaints.recv_timeout(PATIENCE).unwrap_or_default();
        String::from_utf8_lossy(&words).into_owned()
    }

    /// Ends the child, whatever it does, and takes it off the list of processes.
    fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.kill();
    }
}

fn refused(reason: &str) -> Fault {
    Fault::Refused {
        reason: reason.to_owned(),
    }
}

fn garbled(expected: String, got: String) -> Fault {
    Fault::Garbled { expected, got }
}

/// What came, fit for a record.
fn excerpt(bytes: &[u8]) -> String {
    const SHOWN: usize = 60;
    let shown = &bytes[..bytes.len().min(SHOWN)];
    let more = if bytes.len() > SHOWN { "…" } else { "" };
    format!(
        "{:?}{more} ({} bytes)",
        String::from_utf8_lossy(shown),
        bytes.len()
    )
}

/// A thread that writes what it is sent, until the pipe or the sender is gone.
fn writer(mut pipe: ChildStdin) -> Sender<Vec<u8>> {
    let (sender, requests) = channel::<Vec<u8>>();
    thread::spawn(move || {
        while let Ok(request) = requests.recv() {
            if pipe
                .write_all(&request)
                .and_then(|()| pipe.flush())
                .is_err()
            {
                return;
            }
        }
    });
    sender
}

/// A thread that reads to the end of `pipe` and then hands over the last of it.
fn tail(mut pipe: ChildStderr) -> Receiver<Vec<u8>> {
    const KEPT: usize = 4096;
    let (sender, complaints) = channel();
    thread::spawn(move || {
        let mut kept = VecDeque::with_capacity(2 * KEPT);
        let mut chunk = [0; KEPT];
        while let Ok(count @ 1..) = pipe.read(&mut chunk) {
            kept.extend(&chunk[..count]);
            kept.drain(..kept.len().saturating_sub(KEPT));
        }
        let _ = sender.send(Vec::from(kept));
    });
    complaints
}
