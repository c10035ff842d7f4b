//! What the spatial methods ask, and what the paper's text does to the letter.

mod nathan;
mod pivot_wrap;
