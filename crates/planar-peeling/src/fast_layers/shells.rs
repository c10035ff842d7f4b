//! The points that no layer can reach yet, by shells.

use super::outline::Outline;
use super::sorted::Entry;
use geometry_core::{Kernel2, Point2};

/// A set of points and a polygon: the points of this shell and all deeper ones are strictly inside the outline.
struct Shell {
    outline: Option<Outline>,
    entries: Vec<Entry>,
}

/// Points not yet handed out.
pub(super) struct Shells {
    /// The outermost last.
    shells: Vec<Shell>,
    /// How many points are handed out at a time, if so many are left.
    portion: usize,
}

impl Shells {
    /// One shell of all `entries`, which are in lexicographic order, to be handed out in portions.
    pub(super) fn new(entries: Vec<Entry>, portion: usize) -> Self {
        let shell = Shell {
            outline: None,
            entries,
        };
        Self {
            shells: vec![shell],
            portion,
        }
    }

    /// Whether the hull with these halves certainly has all points of the shells strictly inside.
    pub(super) fn are_within<K: Kernel2>(&self, hull: [&[Point2]; 2], kernel: &K) -> bool {
        let Some(shell) = self.shells.last() else {
            return true;
        };
        let outline = shell.outline.as_ref();
        outline.is_some_and(|outline| outline.is_within(hull, kernel))
    }

    /// What all points of the shells are strictly inside of.
    pub(super) fn outline(&self) -> Option<&Outline> {
        self.shells.last().and_then(|shell| shell.outline.as_ref())
    }

    /// Hands out the outermost points: at least as many as `others`, if there are, and not many more if `shape`
    /// can be shrunk to fit.
    pub(super) fn next<K: Kernel2>(
        &mut self,
        shape: &Outline,
        others: usize,
        kernel: &K,
    ) -> Vec<Entry> {
        let want = others.max(self.portion);
        let mut portion: Vec<Entry> = Vec::new();
        while portion.len() < want {
            let Some(mut shell) = self.shells.pop() else {
                break;
            };
            while shell.entries.len() > 2 * want && self.split(&mut shell.entries, shape, kernel) {}
            portion = if portion.is_empty() {
                shell.entries
            } else {
                merged(&portion, &shell.entries)
            };
        }
        portion
    }

    /// Puts about half of `entries`, the inner ones, back into a shell, if `shape` can be shrunk between them.
    fn split<K: Kernel2>(&mut self, entries: &mut Vec<Entry>, shape: &Outline, kernel: &K) -> bool {
        let Some(outline) = shape.halving(entries) else {
            return false;
        };
        let nested = |deeper| outline.holds(deeper, kernel);
        if !self.outline().is_none_or(nested) {
            return false;
        }
        let mut outside = vec![Entry::default(); entries.len()];
        let inner = outline.split(entries, &mut outside, kernel);
        outside.truncate(entries.len() - inner);
        // One point at least on either side, or this would go on for ever.
        if outside.len().min(inner) < (entries.len() / 8).max(1) {
            *entries = merged(&entries[..inner], &outside);
            return false;
        }
        outside.shrink_to_fit();
        entries.truncate(inner);
        entries.shrink_to_fit();
        let inside = std::mem::replace(entries, outside);
        self.shells.push(Shell {
            outline: Some(outline),
            entries: inside,
        });
        true
    }
}

/// Appends to `all` the entries of `a` and `b`, each in lexicographic order, as one list in that order.
pub(super) fn merge_onto(all: &mut Vec<Entry>, a: &[Entry], b: &[Entry]) {
    all.reserve(a.len() + b.len());
    let mut rest = b.iter().peekable();
    for entry in a {
        while let Some(other) = rest.next_if(|other| other.rank < entry.rank) {
            all.push(*other);
        }
        all.push(*entry);
    }
    all.extend(rest);
}

fn merged(a: &[Entry], b: &[Entry]) -> Vec<Entry> {
    let mut all = Vec::new();
    merge_onto(&mut all, a, b);
    all
}
