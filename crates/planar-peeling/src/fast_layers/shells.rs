//! The points that no layer can reach yet, by shells.

use super::outline::Outline;
use super::sorted::Entry;
use geometry_core::{Kernel2, Point2};

/// How many points are handed out at a time, if so many are left.
const PORTION: usize = 4096;

/// A set of points and a polygon: the points of this shell and all deeper ones are strictly inside the outline.
struct Shell {
    outline: Option<Outline>,
    entries: Vec<Entry>,
}

/// Points not yet handed out, the outermost shell last.
pub(super) struct Shells(Vec<Shell>);

impl Shells {
    /// One shell of all `entries`, which are in lexicographic order.
    pub(super) fn new(entries: Vec<Entry>) -> Self {
        let shell = Shell {
            outline: None,
            entries,
        };
        Self(vec![shell])
    }

    /// Whether the hull with these halves certainly has all points of the shells strictly inside.
    pub(super) fn are_within<K: Kernel2>(&self, hull: [&[Point2]; 2], kernel: &K) -> bool {
        let Some(shell) = self.0.last() else {
            return true;
        };
        let outline = shell.outline.as_ref();
        outline.is_some_and(|outline| outline.is_within(hull, kernel))
    }

    /// What all points of the shells are strictly inside of.
    pub(super) fn outline(&self) -> Option<&Outline> {
        self.0.last().and_then(|shell| shell.outline.as_ref())
    }

    /// Hands out the outermost points: at least as many as `others`, if there are, and not many more if `shape`
    /// can be shrunk to fit.
    pub(super) fn next<K: Kernel2>(
        &mut self,
        shape: &Outline,
        others: usize,
        kernel: &K,
    ) -> Vec<Entry> {
        let want = others.max(PORTION);
        let mut portion: Vec<Entry> = Vec::new();
        while portion.len() < want {
            let Some(mut shell) = self.0.pop() else {
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
        let [outside, inside] = outline.split(entries, kernel);
        if outside.len().min(inside.len()) < entries.len() / 8 {
            return false;
        }
        *entries = outside;
        self.0.push(Shell {
            outline: Some(outline),
            entries: inside,
        });
        true
    }
}

/// Two lists of entries in lexicographic order as one.
pub(super) fn merged(a: &[Entry], b: &[Entry]) -> Vec<Entry> {
    let mut all = Vec::with_capacity(a.len() + b.len());
    let mut rest = b.iter().peekable();
    for entry in a {
        while let Some(other) = rest.next_if(|other| other.rank < entry.rank) {
            all.push(*other);
        }
        all.push(*entry);
    }
    all.extend(rest);
    all
}
