//! Hulls by merging the hulls of two halves, after Preparata and Hong.
