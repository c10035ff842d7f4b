//! Merges in space: what they ask and keep, counted, and what rounded cotangents do to them.

mod cotangent;
mod counts;
mod listing;
mod sets;
