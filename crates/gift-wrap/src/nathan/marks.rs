//! The marks that keep work from being done twice, and what it costs to look them up.

use super::options::{Lookup, Marks};
use std::collections::HashSet;

/// Marks on edges or on sides. Only membership is asked, so the order within a hash table never shows.
pub(super) struct MarkBook {
    marks: Marks,
    lookup: Lookup,
    list: Vec<[u32; 2]>,
    table: HashSet<[u32; 2]>,
    comparisons: u64,
}

impl MarkBook {
    pub(super) fn new(marks: Marks, lookup: Lookup) -> Self {
        Self {
            marks,
            lookup,
            list: Vec::new(),
            table: HashSet::new(),
            comparisons: 0,
        }
    }

    /// Marks compared so far; a look into a hash table counts as one.
    pub(super) fn comparisons(&self) -> u64 {
        self.comparisons
    }

    /// Notes that `edge` is put on the stack.
    pub(super) fn add_pushed(&mut self, edge: [u32; 2]) {
        if self.marks == Marks::Edges {
            self.add(edge);
        }
    }

    /// Notes that a triangle with these sides was accepted.
    pub(super) fn add_sides(&mut self, sides: [[u32; 2]; 3]) {
        if self.marks == Marks::Sides {
            for side in sides {
                self.add(side);
            }
        }
    }

    /// Whether the triangle to be found on `edge` was found from another edge while this one was on the stack.
    pub(super) fn is_side_taken(&mut self, edge: [u32; 2]) -> bool {
        self.marks == Marks::Sides && self.is_marked(edge)
    }

    /// Whether `edge` need not be put on the stack.
    pub(super) fn is_marked(&mut self, edge: [u32; 2]) -> bool {
        let key = self.key(edge);
        match self.lookup {
            Lookup::List => {
                let place = self.list.iter().position(|&mark| mark == key);
                let looked_at = place.map_or(self.list.len(), |place| place + 1);
                self.comparisons += looked_at as u64;
                place.is_some()
            }
            Lookup::Hash => {
                self.comparisons += 1;
                self.table.contains(&key)
            }
        }
    }

    fn add(&mut self, edge: [u32; 2]) {
        let key = self.key(edge);
        match self.lookup {
            Lookup::List => self.list.push(key),
            Lookup::Hash => {
                self.table.insert(key);
            }
        }
    }

    /// The paper compares both orders of the ends; with the smaller end first one comparison does for both.
    fn key(&self, [u, v]: [u32; 2]) -> [u32; 2] {
        match self.marks {
            Marks::Edges => [u.min(v), u.max(v)],
            Marks::Sides => [u, v],
        }
    }
}
