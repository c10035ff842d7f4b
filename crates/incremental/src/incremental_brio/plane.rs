//! The plane of a facet, and the side of it that a point is on, in plain floating point with a proved bound.
//!
//! A facet is asked about by two points or three while it lives, and once more for each neighbour at the end. What
//! depends on it alone is computed once: the normal n = (b-p) × (c-p) at the corner p inserted last, to which the others
//! to come are close, and one bound on the error of the height n · (q-p) for every q of the set. A question then costs
//! three differences, three products and two sums.
//!
//! # The bound
//!
//! Write ε = 2⁻⁵³, u = b-p, v = c-p, w = q-p. The height is the sum of six products such as u_y v_z w_x. Each goes through
//! at most eight roundings (three differences, one product, one difference of products, one product, two sums), so what
//! is computed is off by at most ((1+ε)⁸ - 1) Σ |u_j v_k w_i| as long as nothing under- or overflows. In terms of the
//! computed magnitudes
//!
//! ```text
//!     m_i = fl(|u_j v_k| + |u_k v_j|)     and     e_i ≥ |fl(q_i - p_i)| for every point q
//! ```
//!
//! the error is at most (8 ε + 100 ε²) Σ m_i e_i, and evaluating that sum, of positive terms, is off by less than 10 ε
//! of itself. So 9 ε · fl(Σ m_i e_i) is a bound. For e_i stands the rounded extent of the set along axis i: rounding is
//! monotone, so no rounded difference exceeds it.
//!
//! *Scale.* The normal is divided by the height of the eye, so that heights over different facets can be compared (see
//! `walk.rs`): times a factor s, rounded. That is one rounding more of each product, and one of the bound: with 11 ε instead
//! of 9 ε there is room for both.
//!
//! *Underflow.* Sums and differences do not underflow. A product does by at most 2⁻¹⁰⁷⁵: four of them in the normal,
//! times |w_i|, and three in the height. 2⁻¹⁰⁰⁰ is added to each m_i and to the sum: times 11 ε, more than 2⁻¹⁰⁵⁰. The
//! products with s, and the three of the height after it, may underflow where the bound does not know of it; so s is at
//! least 1, or else the plane is [`NONE`](Plane::NONE), and 2⁻¹⁰⁰⁰ times the extents is added to the bound once more.
//!
//! *Overflow.* If a product overflows, some m_i, or the bound, is infinite or NaN. No height is beyond it, the comparison
//! fails, and the question goes to the kernel.
