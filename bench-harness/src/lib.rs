//! The harness behind `hullbench`.
//!
//! | module | holds |
//! |---|---|
//! | [`analysis`] | questions about recorded runs, answered from the records alone |
//! | [`commands`] | the subcommands on a user's own points and on recorded runs |
//! | [`records`] | a run on disk: its rows, read, written and appended |
//! | [`stats`] | intervals, tests and fits: plain functions of plain slices |
//! | [`engine`] | programs that compute, each in a process of its own, behind one pipe protocol |
//! | [`claimed`] | hulls as others state them, as values for the checker |
//! | [`output`] | how results leave the program: CSV, JSON, summaries; files that appear whole or not at all |
//! | [`failure`] | why the program stops early, and the exit code that says so |
//! | [`counting`] | a method run with every question counted |
//! | `definition` | an experiment as data |
//! | [`measure`] | engines verified, counted and timed, into a run on disk |
//! | [`report`] | a recorded run as one HTML file |
//! | [`gate`] | the exact counts that are expected to stay as they are |
//! | `provenance`, `progress`, `parallel` | where a run comes from; how far it is; two sets at a time |
//! | [`reproduce`] | the papers: definitions, experiments, tables, figures, verdicts |

pub mod analysis;
pub mod claimed;
pub mod commands;
pub mod counting;
mod definition;
pub mod engine;
pub mod failure;
pub mod gate;
pub mod measure;
pub mod output;
mod parallel;
mod progress;
mod provenance;
pub mod records;
pub mod report;
pub mod reproduce;
pub mod stats;
