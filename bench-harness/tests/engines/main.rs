//! Engines behind the pipe protocol: ours, and one that misbehaves in every way we could think of.

mod fake;
mod own;
mod peers;
