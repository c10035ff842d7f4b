//! The harness behind `hullbench`.
//!
//! | module | holds |
//! |---|---|
//! | [`analysis`] | questions about recorded runs, answered from the records alone |
//! | [`commands`] | the subcommands on a user's own points and on recorded runs |
//! | [`records`] | a run on disk: its rows, read, written and appended |
//! | [`stats`] | intervals, tests and fits: plain functions of plain slices |
//! | [`output`] | how results leave the program: CSV, JSON, summaries; files that appear whole or not at all |
//! | [`failure`] | why the program stops early, and the exit code that says so |
//! | [`reproduce`] | the papers: definitions, experiments, tables, figures, verdicts |

pub mod analysis;
pub mod commands;
pub mod failure;
pub mod output;
pub mod records;
pub mod reproduce;
pub mod stats;
