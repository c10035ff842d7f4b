//! Hulls by gift wrapping, after Jarvis.
