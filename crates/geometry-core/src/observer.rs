//! Hooks through which an algorithm tells what it does, for counting and for teaching.
//!
//! An algorithm calls [`Observer::step`] with a closure. With [`Silent`], whose [`ACTIVE`](Observer::ACTIVE) is
//! `false`, the closure is never built and the compiled code is that of the algorithm without hooks.

/// One thing an algorithm did. Points are indices into the caller's slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Step {
    /// A point's coordinates were looked at in a pass over a list.
    Visit(u32),
    /// The directed line was taken up for examination.
    Line(u32, u32),
    /// The point was found furthest outside the line under examination, or the best candidate for the next vertex.
    Apex(u32),
    /// The directed edge was confirmed as an edge of the hull.
    Edge(u32, u32),
    /// The point was put at the end of the chain.
    Push(u32),
    /// The point was taken back from the chain: it is not a vertex.
    Pop(u32),
    /// The point was found to be no vertex and will not be looked at again.
    Discard(u32),
    /// The point was inserted into the hull between two vertices.
    Insert(u32),
    /// The two hulls are joined by this supporting line.
    Bridge(u32, u32),
    /// Two hulls of this many vertices in all were merged.
    Merge(u32),
    /// A facet with these corners was made.
    Facet(u32, u32, u32),
    /// A facet with these corners was dropped.
    Drop(u32, u32, u32),
    /// The angle of a candidate edge was examined in a merge by wrapping.
    Candidate(u32),
    /// A layer with this 1-based number is complete.
    Layer(u32),
    /// The working storage beyond the promised arrays now holds this many records.
    Storage(u32),
}

/// Receives the steps of an algorithm.
pub trait Observer {
    /// Whether [`record`](Self::record) is ever called. `false` removes the hooks at compile time.
    const ACTIVE: bool;

    /// Takes one step.
    fn record(&mut self, step: Step);

    /// Takes the step that `make` builds, if anyone listens.
    #[inline(always)]
    fn step(&mut self, make: impl FnOnce() -> Step) {
        if Self::ACTIVE {
            self.record(make());
        }
    }
}

/// Hears nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    const ACTIVE: bool = false;
    fn record(&mut self, _: Step) {}
}

/// Keeps every step, for teaching and for tests.
#[derive(Clone, Debug, Default)]
pub struct Recorder {
    /// The steps in the order they were taken.
    pub steps: Vec<Step>,
}

impl Observer for Recorder {
    const ACTIVE: bool = true;
    fn record(&mut self, step: Step) {
        self.steps.push(step);
    }
}

/// Counts steps by kind. Exact integers, equal on every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Points looked at ([`Step::Visit`]).
    pub visits: u64,
    /// Lines examined ([`Step::Line`]).
    pub lines: u64,
    /// Apexes found ([`Step::Apex`]).
    pub apexes: u64,
    /// Edges confirmed ([`Step::Edge`]).
    pub edges: u64,
    /// Points put on a chain ([`Step::Push`]).
    pub pushes: u64,
    /// Points taken back ([`Step::Pop`]).
    pub pops: u64,
    /// Points discarded ([`Step::Discard`]).
    pub discards: u64,
    /// Points inserted ([`Step::Insert`]).
    pub inserts: u64,
    /// Supporting lines found ([`Step::Bridge`]).
    pub bridges: u64,
    /// Merges ([`Step::Merge`]).
    pub merges: u64,
    /// Facets made ([`Step::Facet`]).
    pub facets: u64,
    /// Facets dropped ([`Step::Drop`]).
    pub drops: u64,
    /// Candidates examined ([`Step::Candidate`]).
    pub candidates: u64,
    /// Layers completed ([`Step::Layer`]).
    pub layers: u64,
    /// The most records of working storage in use at once ([`Step::Storage`]).
    pub storage: u64,
}

impl Observer for Tally {
    const ACTIVE: bool = true;
    fn record(&mut self, step: Step) {
        match step {
            Step::Visit(_) => self.visits += 1,
            Step::Line(..) => self.lines += 1,
            Step::Apex(_) => self.apexes += 1,
            Step::Edge(..) => self.edges += 1,
            Step::Push(_) => self.pushes += 1,
            Step::Pop(_) => self.pops += 1,
            Step::Discard(_) => self.discards += 1,
            Step::Insert(_) => self.inserts += 1,
            Step::Bridge(..) => self.bridges += 1,
            Step::Merge(_) => self.merges += 1,
            Step::Facet(..) => self.facets += 1,
            Step::Drop(..) => self.drops += 1,
            Step::Candidate(_) => self.candidates += 1,
            Step::Layer(_) => self.layers += 1,
            Step::Storage(records) => self.storage = self.storage.max(u64::from(records)),
        }
    }
}

impl<O: Observer> Observer for &mut O {
    const ACTIVE: bool = O::ACTIVE;
    fn record(&mut self, step: Step) {
        (**self).record(step);
    }
}
