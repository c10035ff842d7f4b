//! The subcommands on a user's own points.
