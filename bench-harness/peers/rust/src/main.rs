//! Rust crates as engines of hullbench: `hullbench-peers ENGINE` answers the pipe protocol.

mod crates;
mod protocol;

use std::process::ExitCode;

fn main() -> ExitCode {
    let name = std::env::args().nth(1).unwrap_or_default();
    let Some(mut engine) = crates::engine(&name) else {
        eprintln!("usage: hullbench-peers ENGINE");
        return ExitCode::from(2);
    };
    match protocol::serve(&name, &mut *engine) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
