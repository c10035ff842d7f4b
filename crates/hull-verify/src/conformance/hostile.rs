//! Kernels whose answers contradict each other, and a bound on how long a method may listen to them.

use geometry_core::{Kernel2, Point2, Sign, Stage};
use std::cell::Cell;
use std::cmp::Ordering;

/// How a hostile kernel lies about sides and distances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lie {
    /// The same question gets the same answer, a random one.
    Settled,
    /// Every question gets a new random answer.
    Fickle,
}

/// What a hostile kernel says of orders. They are total in any case: sorting by them is safe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orders {
    /// The truth, as far as `f64` can tell.
    True,
    /// Some other order.
    False,
}

/// A kernel that answers at random.
#[derive(Clone, Debug)]
pub struct Hostile {
    lie: Lie,
    orders: Orders,
    asked: Cell<u64>,
}

impl Hostile {
    /// The kernel that lies about sides and distances as `lie` says, and gives `orders`.
    pub fn new(lie: Lie, orders: Orders) -> Self {
        Self {
            lie,
            orders,
            asked: Cell::new(0),
        }
    }

    /// One kernel of each kind.
    pub fn all() -> [Self; 4] {
        [
            Self::new(Lie::Settled, Orders::True),
            Self::new(Lie::Settled, Orders::False),
            Self::new(Lie::Fickle, Orders::True),
            Self::new(Lie::Fickle, Orders::False),
        ]
    }

    /// What it is, for a report.
    pub fn name(&self) -> &'static str {
        match (self.lie, self.orders) {
            (Lie::Settled, Orders::True) => "tallied, settled lies, true orders",
            (Lie::Settled, Orders::False) => "tallied, settled lies, false orders",
            (Lie::Fickle, Orders::True) => "tallied, fickle lies, true orders",
            (Lie::Fickle, Orders::False) => "tallied, fickle lies, false orders",
        }
    }

    /// A random answer to the question about `points`: every sign is as likely as every other.
    fn answer(&self, points: &[Point2]) -> Ordering {
        let number = self.asked.get() + 1;
        self.asked.set(number);
        let hash = match self.lie {
            Lie::Settled => hash(points),
            Lie::Fickle => mix(number),
        };
        match hash % 3 {
            0 => Ordering::Less,
            1 => Ordering::Equal,
            _ => Ordering::Greater,
        }
    }
}

impl Kernel2 for Hostile {
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        (Sign::from(self.answer(&[a, b, c])), Stage::Filter)
    }

    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        (self.answer(&[a, b, p, q]), Stage::Filter)
    }

    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        if self.lexicographic(a, b).is_gt() {
            self.lexicographic(q, p)
        } else {
            self.lexicographic(p, q)
        }
    }

    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        let truth = crate::arithmetic::order(a, b);
        match self.orders {
            Orders::True => truth,
            // Hashes order the points, the truth those of equal hash.
            Orders::False => hash(&[a]).cmp(&hash(&[b])).then(truth),
        }
    }

    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        let angle = |p: Point2| match self.orders {
            Orders::True => (p[1] - center[1]).atan2(p[0] - center[0]),
            Orders::False => hash(&[center, p]) as f64,
        };
        angle(a).total_cmp(&angle(b))
    }
}

/// A hash of coordinates in which the two zeros are equal.
fn hash(points: &[Point2]) -> u64 {
    points
        .as_flattened()
        .iter()
        .fold(0, |state, &x| mix(state ^ (x + 0.0).to_bits()))
}

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection that spreads every bit.
pub(super) fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Passes questions on until there were too many, then panics: a method that asks for ever is stopped, one that
/// loops without asking is not.
pub struct Budget<'a> {
    inner: &'a dyn Kernel2,
    budget: u64,
    left: Cell<u64>,
}

impl<'a> Budget<'a> {
    /// Allows 1000 (n + 10)² questions about `n` points: far more than any method here needs for true answers.
    pub fn new(inner: &'a dyn Kernel2, n: usize) -> Self {
        let budget = 1000 * (n as u64 + 10).pow(2);
        Self {
            inner,
            budget,
            left: Cell::new(budget),
        }
    }

    fn spend(&self) -> &'a dyn Kernel2 {
        let left = self.left.get();
        assert!(
            left > 0,
            "more than {} questions asked: with contradictory answers the method does not stop",
            self.budget
        );
        self.left.set(left - 1);
        self.inner
    }
}

impl Kernel2 for Budget<'_> {
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        self.spend().orient_staged(a, b, c)
    }

    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        self.spend().compare_distance_staged(a, b, p, q)
    }

    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        self.spend().compare_along(a, b, p, q)
    }

    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        self.spend().lexicographic(a, b)
    }

    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        self.spend().compare_angle(center, a, b)
    }
}
