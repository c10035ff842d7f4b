//! The outside programs: what they compute, what they need, how they are built.
//!
//! Their sources lie in `bench-harness/peers/`, outside the workspace; every one is started with the name of the engine
//! it is to be as its only argument. Nothing here installs anything: what is missing is named, and everything else
//! works without.

pub mod build;
mod needs;
mod programs;

pub use needs::Need;
pub use programs::PROGRAMS;

use super::protocol::Problem;

/// An outside program, which is one or more engines.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Its name, and that of its folder in the cache.
    pub name: &'static str,
    /// How it is built.
    pub recipe: Recipe,
    /// Its sources below `bench-harness/peers/`, the main one first.
    pub sources: &'static [&'static str],
    /// What must be installed.
    pub needs: &'static [Need],
    /// What it can be.
    pub engines: &'static [Peer],
}

/// An engine that is not ours.
#[derive(Clone, Copy, Debug)]
pub struct Peer {
    /// The name it is called by in definitions, tables and records.
    pub name: &'static str,
    /// What it computes.
    pub problems: &'static [Problem],
    /// What it is, and what to know before comparing with it.
    pub about: &'static str,
}

/// How a program comes to be.
#[derive(Clone, Copy, Debug)]
pub enum Recipe {
    /// Compiled from one C++ file.
    Cpp {
        /// Options beside those that all have.
        options: &'static [&'static str],
        /// Libraries to link.
        libraries: &'static [&'static str],
    },
    /// A Python script, run by an interpreter that has these modules.
    Python {
        /// Modules that the script imports.
        modules: &'static [&'static str],
    },
    /// A workspace of its own with its own lock file, built by Cargo.
    Cargo,
}

/// The program that is the engine `name`, or is called `name` itself.
pub fn program(name: &str) -> Option<&'static Program> {
    PROGRAMS.iter().find(|program| {
        program.name == name || program.engines.iter().any(|engine| engine.name == name)
    })
}

/// Every peer, with the program that is it.
pub fn all() -> impl Iterator<Item = (&'static Program, &'static Peer)> {
    let engines =
        |program: &'static Program| program.engines.iter().map(move |peer| (program, peer));
    PROGRAMS.iter().flat_map(engines)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_name_is_said_once_and_is_none_of_ours() {
        let mut names = BTreeSet::new();
        for (_, peer) in all() {
            assert!(names.insert(peer.name), "{}", peer.name);
            assert!(hullkit::method(peer.name).is_none(), "{}", peer.name);
            assert!(!peer.problems.is_empty() && !peer.about.is_empty());
        }
    }

    #[test]
    fn a_program_is_found_by_its_name_and_by_its_engines() {
        for (owner, peer) in all() {
            assert_eq!(program(peer.name).unwrap().name, owner.name);
            assert_eq!(program(owner.name).unwrap().name, owner.name);
        }
        assert!(program("gs").is_none());
    }

    #[test]
    fn every_source_is_there() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("peers");
        for program in PROGRAMS {
            for source in program.sources {
                assert!(folder.join(source).is_file(), "{source}");
            }
        }
    }
}
