//! The papers, regenerated and judged.
