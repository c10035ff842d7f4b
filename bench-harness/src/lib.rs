//! The harness behind `hullbench`.
//!
//! | module | holds |
//! |---|---|
//! | [`commands`] | the subcommands on a user's own points |
//! | [`engine`] | programs that compute, each in a process of its own, behind one pipe protocol |
//! | [`claimed`] | hulls as others state them, as values for the checker |
//! | [`output`] | how results leave the program: CSV, JSON, summaries; files that appear whole or not at all |
//! | [`failure`] | why the program stops early, and the exit code that says so |
//! | [`reproduce`] | the papers: definitions, experiments, tables, figures, verdicts |

pub mod claimed;
pub mod commands;
pub mod engine;
pub mod failure;
pub mod output;
pub mod reproduce;
