//! Every engine known, and how to start it.

use super::client::Launch;
use super::fault::Fault;
use super::peers::{self, Peer, Program, build};
use super::protocol::Problem;
use super::yardstick::{YARDSTICKS, Yardstick};
use crate::records::rows::twin_of;
use geometry_core::Method;
use std::env;
use std::io;
use std::path::{Path, PathBuf};

/// Where things are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Places {
    /// This program, which serves our methods.
    pub hullbench: PathBuf,
    /// The sources of the peers, if they were found.
    pub sources: Option<PathBuf>,
    /// Where peers are built.
    pub cache: PathBuf,
}

impl Places {
    /// The usual places: the sources in the workspace round the current folder or the one this program was built in,
    /// the cache in its `target/peers`. Both can be named.
    ///
    /// # Errors
    ///
    /// Those of finding the current folder or this program.
    pub fn find(sources: Option<&Path>, cache: Option<&Path>) -> io::Result<Self> {
        let here = env::current_dir()?;
        let sources = match sources {
            Some(named) => Some(here.join(named)),
            None => sources_round(&here),
        };
        let cache = match (cache, &sources) {
            (Some(named), _) => here.join(named),
            (None, Some(sources)) => sources.join("../../target/peers"),
            (None, None) => here.join("target/peers"),
        };
        Ok(Self {
            hullbench: env::current_exe()?,
            sources,
            cache,
        })
    }
}

/// The folder of the sources in `here` or a folder round it, or where this program was built.
fn sources_round(here: &Path) -> Option<PathBuf> {
    let round = here
        .ancestors()
        .map(|folder| folder.join("bench-harness/peers"));
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers");
    round.chain([built]).find(|folder| folder.is_dir())
}

/// An engine.
#[derive(Clone, Copy, Debug)]
pub enum Entry {
    /// One of our methods.
    Own(&'static Method),
    /// Work of a known size.
    Yardstick(Yardstick),
    /// A program of others.
    Peer(&'static Program, &'static Peer),
}

/// Every engine: our methods, the yardsticks, the peers.
pub fn all() -> impl Iterator<Item = Entry> {
    let own = hullkit::methods().filter(|method| Problem::of(method).is_some());
    own.map(Entry::Own)
        .chain(YARDSTICKS.map(|(yardstick, ..)| Entry::Yardstick(yardstick)))
        .chain(peers::all().map(|(program, peer)| Entry::Peer(program, peer)))
}

/// The engine `name`, or the one whose twin it is.
pub fn find(name: &str) -> Option<Entry> {
    let name = twin_of(name).unwrap_or(name);
    all().find(|entry| entry.name() == name)
}

/// Whether the engine `name` computes `problem`.
///
/// # Errors
///
/// Why not, in words.
pub fn knows(name: &str, problem: Problem) -> Result<(), String> {
    match find(name) {
        None => Err(format!("no engine is called '{name}'")),
        Some(entry) if !entry.problems().contains(&problem) => {
            Err(format!("'{name}' does not compute {problem}"))
        }
        Some(_) => Ok(()),
    }
}

impl Entry {
    /// The name it is called by.
    pub fn name(&self) -> &'static str {
        match self {
            Entry::Own(method) => method.slug,
            Entry::Yardstick(yardstick) => yardstick.name(),
            Entry::Peer(_, peer) => peer.name,
        }
    }

    /// What it computes.
    pub fn problems(&self) -> Vec<Problem> {
        match self {
            Entry::Own(method) => Problem::of(method).into_iter().collect(),
            Entry::Yardstick(_) => Problem::ALL.to_vec(),
            Entry::Peer(_, peer) => peer.problems.to_vec(),
        }
    }

    /// How to start it.
    ///
    /// # Errors
    ///
    /// [`Fault::Absent`] for a peer that is not built.
    pub fn launch(&self, places: &Places) -> Result<Launch, Fault> {
        let engine = self.name().to_owned();
        match self {
            Entry::Own(_) | Entry::Yardstick(_) => Ok(Launch {
                engine,
                program: places.hullbench.clone(),
                arguments: vec!["engine".into(), self.name().into()],
            }),
            Entry::Peer(program, peer) => {
                let built = build::built(program, places);
                let built = built.map_err(|missing| Fault::Absent { missing })?;
                let arguments = built.arguments.into_iter().map(PathBuf::into_os_string);
                Ok(Launch {
                    engine,
                    program: built.program,
                    arguments: arguments.chain([peer.name.into()]).collect(),
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::rows::twin;

    #[test]
    fn engines_and_their_twins_are_found_by_name() {
        for entry in all() {
            let found = find(entry.name()).expect("an engine of the list");
            assert_eq!(found.name(), entry.name());
            let twin = find(&twin(entry.name())).expect("a twin");
            assert_eq!(twin.name(), entry.name());
        }
        assert!(find("qhull@brother").is_none() && find("nobody").is_none());
    }

    #[test]
    fn a_peer_that_is_not_built_is_absent() {
        let folder = tempfile::tempdir().unwrap();
        let places = Places {
            hullbench: PathBuf::from("hullbench"),
            sources: None,
            cache: folder.path().to_owned(),
        };
        let fault = find("qhull").unwrap().launch(&places).unwrap_err();
        assert_eq!(fault.word(), "absent");
        assert!(fault.to_string().contains("peers build qhull"), "{fault}");
    }
}
