//! Who can take part: the engines of the catalogue, and guests named on the command line.

use super::instructions;
use crate::engine::catalogue::{self, Entry, Places};
use crate::engine::client::Launch;
use crate::engine::fault::Fault;
use crate::engine::protocol::Problem;
use crate::progress::say;
use crate::records::rows::twin_of;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::OnceLock;

/// A program that is no part of the catalogue: `NAME=PROGRAM`, with arguments after spaces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Guest {
    pub(super) name: String,
    program: PathBuf,
    arguments: Vec<String>,
}

impl FromStr for Guest {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, command) = text.split_once('=').ok_or("NAME=PROGRAM")?;
        let mut words = command.split_whitespace();
        let program = words.next().ok_or("NAME=PROGRAM: no program is named")?;
        if catalogue::find(name).is_some() {
            return Err(format!("there is an engine '{name}' already"));
        }
        Ok(Self {
            name: name.to_owned(),
            program: program.into(),
            arguments: words.map(str::to_owned).collect(),
        })
    }
}

/// Everyone who can take part.
#[derive(Clone, Debug)]
pub(super) struct Roster {
    places: Places,
    guests: Vec<Guest>,
    has_valgrind: OnceLock<bool>,
}

impl Roster {
    pub(super) fn new(guests: &[Guest]) -> std::io::Result<Self> {
        let places = Places::find(None, None)?;
        Ok(Self {
            places,
            guests: guests.to_vec(),
            has_valgrind: OnceLock::new(),
        })
    }

    /// Whether the engine `name` computes `problem`; if not, why.
    pub(super) fn knows(&self, name: &str, problem: Problem) -> Result<(), String> {
        if self.guests.iter().any(|guest| guest.name == name) {
            return Ok(());
        }
        catalogue::knows(name, problem)
    }

    /// Whether instructions can be counted; said once if they cannot.
    pub(super) fn has_valgrind(&self) -> bool {
        *self.has_valgrind.get_or_init(|| {
            let can_count = instructions::can_count();
            if !can_count {
                say("no instructions are counted: valgrind is not installed");
            }
            can_count
        })
    }

    /// How to start the engine `name`, or the one whose twin it is.
    pub(super) fn launch(&self, name: &str) -> Result<Launch, Fault> {
        let name = twin_of(name).unwrap_or(name);
        if let Some(guest) = self.guests.iter().find(|guest| guest.name == name) {
            return Ok(Launch {
                engine: guest.name.clone(),
                program: guest.program.clone(),
                arguments: guest.arguments.iter().map(Into::into).collect(),
            });
        }
        let missing = || Fault::Absent {
            missing: format!("no engine is called '{name}'"),
        };
        catalogue::find(name)
            .ok_or_else(missing)?
            .launch(&self.places)
    }

    /// What the engine `name` is for, if it is to compute no hull.
    pub(super) fn yardstick(&self, name: &str) -> Option<&'static str> {
        match catalogue::find(name) {
            Some(Entry::Yardstick(yardstick)) => Some(yardstick.about()),
            _ => None,
        }
    }
}
