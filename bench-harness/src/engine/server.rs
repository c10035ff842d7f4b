//! The engine's end of the pipe: the loop that answers.

use super::answer::Answer;
use super::protocol::{Command, Counters, Load, Loaded, Receipt, Reply, Run, Samples, line};
use serde::Serialize;
use std::io::{self, BufRead, Write};

/// What answers. A refusal is a reason in words.
pub trait Engine {
    /// Who this is.
    fn receipt(&self) -> Receipt;

    /// Takes sets of points, set by set, coordinate by coordinate, and converts them to whatever [`run`](Self::run)
    /// needs.
    ///
    /// # Errors
    ///
    /// The reason of a refusal.
    fn load(&mut self, load: &Load, coordinates: Vec<f64>) -> Result<(), String>;

    /// Takes samples, in nanoseconds, and keeps the last result of each set.
    ///
    /// # Errors
    ///
    /// The reason of a refusal.
    fn run(&mut self, run: &Run) -> Result<Vec<u64>, String>;

    /// The last result of set number `set`.
    ///
    /// # Errors
    ///
    /// The reason of a refusal.
    fn hull(&mut self, set: u32) -> Result<Answer, String>;

    /// Whatever is counted, in a run of its own.
    ///
    /// # Errors
    ///
    /// The reason of a refusal.
    fn counters(&mut self) -> Result<Counters, String>;
}

/// Answers the commands from `input` on `output` until `quit` or the end of the input.
///
/// # Errors
///
/// Those of the pipe; [`io::ErrorKind::InvalidData`] for a `load` that does not say how many bytes follow.
pub fn serve(
    engine: &mut dyn Engine,
    input: &mut dyn BufRead,
    output: &mut dyn Write,
) -> io::Result<()> {
    let mut text = String::new();
    loop {
        text.clear();
        if input.read_line(&mut text)? == 0 {
            return Ok(());
        }
        match text.parse() {
            Ok(Command::Version) => reply(output, Ok(engine.receipt()))?,
            Ok(Command::Load(load)) => {
                let coordinates = read_points(input, &load)?;
                let done = engine.load(&load, coordinates);
                let (loaded, sets) = (load.n, load.sets);
                reply(output, done.map(|()| Loaded { loaded, sets }))?;
            }
            Ok(Command::Run(run)) => {
                let samples = engine.run(&run);
                reply(output, samples.map(|nanoseconds| Samples { nanoseconds }))?;
            }
            Ok(Command::Hull(which)) => match engine.hull(which.set) {
                Ok(answer) => {
                    reply(output, Ok(answer.header()))?;
                    answer.write(output)?;
                }
                Err(reason) => reply::<()>(output, Err(reason))?,
            },
            Ok(Command::Counters) => reply(output, engine.counters())?,
            Ok(Command::Quit) => return Ok(()),
            // After a `load` that is not understood nobody knows where the next command begins.
            Err(reason) if text.starts_with("load") => {
                return Err(io::Error::new(io::ErrorKind::InvalidData, reason));
            }
            Err(reason) => reply::<()>(output, Err(reason))?,
        }
        output.flush()?;
    }
}

fn reply<T: Serialize>(output: &mut dyn Write, what: Result<T, String>) -> io::Result<()> {
    let reply = match what {
        Ok(done) => Reply::Done(done),
        Err(refused) => Reply::Refused { refused },
    };
    writeln!(output, "{}", line(&reply))
}

fn read_points(input: &mut dyn BufRead, load: &Load) -> io::Result<Vec<f64>> {
    let Some(bytes) = load.bytes() else {
        let reason = format!(
            "no {} sets of {} points of {} coordinates for {}",
            load.sets, load.n, load.dimension, load.task
        );
        return Err(io::Error::new(io::ErrorKind::InvalidData, reason));
    };
    let mut coordinates = Vec::with_capacity(bytes / size_of::<f64>());
    let mut block = [0; 1 << 13];
    let mut left = bytes;
    while left > 0 {
        let count = left.min(block.len());
        input.read_exact(&mut block[..count])?;
        let (numbers, _) = block[..count].as_chunks();
        coordinates.extend(numbers.iter().map(|number| f64::from_le_bytes(*number)));
        left -= count;
    }
    Ok(coordinates)
}
