//! The harness behind `hullbench`.
//!
//! | module | holds |
//! |---|---|
//! | [`commands`] | the subcommands on a user's own points |
//! | [`reproduce`] | the papers: definitions, experiments, tables, figures, verdicts |

pub mod commands;
pub mod reproduce;
