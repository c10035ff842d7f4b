//! How the questions of a merge are asked: fast, or fast and counted.

use geometry_core::exact::{Boxed, Unit};
use geometry_core::{Counted, InCircle, Kernel2, Points, QuestionCounts};

/// Hands out the kernel for the points of a box, and takes it back.
pub(super) trait Asking {
    /// The kernel that answers about the points of one box.
    type Kernel: Kernel2 + InCircle;

    /// The kernel for a box of this width and height.
    fn in_box(&self, width: f64, height: f64) -> Self::Kernel;

    /// No more will be asked of `kernel`.
    fn done(&mut self, kernel: Self::Kernel);
}

/// Exact answers, by filters made for each box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Filtered {
    unit: Unit,
}

impl Filtered {
    pub(super) fn new(points: Points<'_, 2>) -> Self {
        let unit = Unit::of(points.as_slice());
        Self { unit }
    }
}

impl Asking for Filtered {
    type Kernel = Boxed;

    #[inline(always)]
    fn in_box(&self, width: f64, height: f64) -> Boxed {
        Boxed::new(width, height, self.unit)
    }

    #[inline(always)]
    fn done(&mut self, _: Boxed) {}
}

/// The same answers, every question counted.
#[derive(Debug)]
pub(super) struct Tallied {
    pub(super) filtered: Filtered,
    pub(super) counts: QuestionCounts,
}

impl Asking for Tallied {
    type Kernel = Counted<Boxed>;

    fn in_box(&self, width: f64, height: f64) -> Counted<Boxed> {
        Counted::new(self.filtered.in_box(width, height))
    }

    fn done(&mut self, kernel: Counted<Boxed>) {
        self.counts += kernel.counts();
    }
}
