//! Hulls by inserting one point at a time.
