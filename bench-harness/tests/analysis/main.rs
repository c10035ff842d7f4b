//! What the analyses say about made-up runs whose truth is known.

mod cmp;
mod diff;
mod export;
mod fit;
mod made_up;
mod rank;
mod table;
