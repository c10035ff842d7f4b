//! The storage of method GS: the arrays LIST and NWK and the stack of labels.
//!
//! ```text
//!  LIST  [ peel 1 | peel 2 | ... |   free   | not yet peeled ]
//!                                ^ front    ^ tail            n
//!
//!  NWK   [ l k . . . . |  free  | l k . . | l k . ]     an item: its length l, the furthest point k, the others
//! ```
//!
//! The words of both arrays are `u32`. A degenerate item of two or more points has its length flagged by a
//! minus sign, in two's complement; lengths therefore stop at 2³¹ - 1.

/// The address of a test list without points: the label of an edge.
pub(crate) const EDGE: u32 = u32::MAX;

/// The label of a test list: the directed line from→to and the address of its item in NWK.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Label {
    pub(crate) from: u32,
    pub(crate) to: u32,
    pub(crate) at: u32,
}

/// The label of a peel: a segment of LIST, and whether all its points are collinear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PeelLabel {
    pub(crate) at: u32,
    pub(crate) len: u32,
    pub(crate) flat: bool,
}

/// An item of NWK, as its length word and the label's address describe it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Item {
    /// No points: the line is an edge.
    Empty,
    /// One point.
    Single(u32),
    /// Two or more points, all on the line and between its ends.
    Degenerate { len: usize },
    /// Two or more points, the furthest outside the line first.
    Proper { len: usize },
}

/// LIST, NWK and the stack of labels.
pub(crate) struct Arrays {
    /// Peels at the front, points not yet peeled at the tail, free cells between.
    pub(crate) list: Vec<u32>,
    /// End of the peels in LIST.
    pub(crate) front: usize,
    /// Start of the points not yet peeled.
    pub(crate) tail: usize,
    /// The items of the test lists.
    pub(crate) nwk: Vec<u32>,
    /// Labels of the peels found by earlier calls.
    pub(crate) peels: Vec<PeelLabel>,
    /// Labels of confirmed edges of the present peel, in anticlockwise order.
    pub(crate) edges: Vec<Label>,
    /// Labels of the other test lists of the present peel, the next anticlockwise on top.
    pub(crate) open: Vec<Label>,
}

impl Arrays {
    /// Nothing peeled yet of `n` points.
    pub(crate) fn new(n: u32) -> Self {
        Self {
            list: (0..n).collect(),
            front: 0,
            tail: 0,
            nwk: vec![0; n as usize],
            peels: Vec::new(),
            edges: Vec::new(),
            open: Vec::new(),
        }
    }

    /// How many points are not yet peeled.
    pub(crate) fn left(&self) -> usize {
        self.list.len() - self.tail
    }

    /// How many labels are in use: the paper's m is the most there ever are.
    pub(crate) fn labels(&self) -> u32 {
        (self.peels.len() + self.edges.len() + self.open.len()) as u32
    }

    /// The points of a peel, anticlockwise.
    pub(crate) fn peel(&self, label: PeelLabel) -> &[u32] {
        &self.list[label.at as usize..][..label.len as usize]
    }

    /// What the label's item holds.
    pub(crate) fn item(&self, label: Label) -> Item {
        if label.at == EDGE {
            return Item::Empty;
        }
        let at = label.at as usize;
        match self.nwk[at] as i32 {
            1 => Item::Single(self.nwk[at + 1]),
            flagged if flagged < 0 => Item::Degenerate {
                len: flagged.unsigned_abs() as usize,
            },
            len => Item::Proper { len: len as usize },
        }
    }

    /// Completes the item at `at`, whose `len` points are in place: sets its length, flags it as degenerate if
    /// no point of it is furthest, and otherwise moves the furthest to the first place. Returns its address.
    pub(crate) fn complete(&mut self, at: usize, len: usize, furthest: Option<usize>) -> u32 {
        if len == 0 {
            return EDGE;
        }
        let length = len as u32;
        self.nwk[at] = match furthest {
            None if len > 1 => length.wrapping_neg(),
            _ => length,
        };
        if let Some(place) = furthest {
            self.nwk.swap(at + 1, place);
        }
        at as u32
    }
}
