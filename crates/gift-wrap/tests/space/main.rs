//! The spatial methods: that they are right, what they ask, and what the paper's text does to the letter.

mod nathan;
mod pivot_wrap;
mod right;
mod sets;
