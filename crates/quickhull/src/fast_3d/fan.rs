//! The planes of the facets about a new corner, side by side, so that one point is asked about all of them at once.
//!
//! All facets of a cone share its apex, so a point has one difference from it, the *spoke*, and its height over each plane is the
//! product of that and a normal: the same arithmetic as [`Plane::height`], in vectors as wide as the machine has.
//!
//! ```text
//!            apex
//!           / | \          lane i is the facet (rim i, rim i+1, apex),
//!          /  |  \         its plane that of Plane::through([apex, rim i, rim i+1])
//!     ... i -i+1- i+2 ...
//! ```

use super::plane::{NO_DOUBT, Plane};
use geometry_core::Point3;
use pulp::Simd;

/// So many facets are side by side: more than most cones have.
pub(super) const LANES: usize = 8;

type Lanes = [f64; LANES];

/// The planes of up to [`LANES`] facets that follow one another about an apex. Lanes without a facet have every point within.
#[derive(Debug)]
pub(super) struct Fan {
    apex: Point3,
    /// How many lanes have a facet.
    count: usize,
    normals: [Lanes; 3],
    bounds: Lanes,
    doubts: Lanes,
}

impl Fan {
    /// A fan without facets.
    #[inline(always)]
    pub(super) fn about(apex: Point3) -> Self {
        Self {
            apex,
            count: 0,
            normals: [[0.0; LANES]; 3],
            bounds: [f64::INFINITY; LANES],
            doubts: [NO_DOUBT; LANES],
        }
    }

    /// Adds the facet with this plane, which goes through the apex, in the next lane. There is room for [`LANES`].
    #[inline(always)]
    pub(super) fn push(&mut self, plane: &Plane) {
        debug_assert!(self.count < LANES);
        let lane = self.count % LANES;
        for (normals, normal) in self.normals.iter_mut().zip(plane.normal) {
            normals[lane] = normal;
        }
        self.bounds[lane] = plane.bound;
        self.doubts[lane] = plane.doubt;
        self.count += 1;
    }

    /// The first lane that `p` is outside of, or [`LANES`]; `None` if it is not sure.
    #[inline(always)]
    pub(super) fn first_outside<S: Simd>(&self, simd: S, p: &Point3) -> Option<usize> {
        let spoke = [
            simd.splat_f64s(p[0] - self.apex[0]),
            simd.splat_f64s(p[1] - self.apex[1]),
            simd.splat_f64s(p[2] - self.apex[2]),
        ];
        let mut first = self.numbers(simd, spoke, 0);
        let all = LANES / S::F64_LANES;
        let needed = if self.count <= LANES / 2 {
            all.div_ceil(2)
        } else {
            all
        };
        for vector in 1..needed {
            let number = self.numbers(simd, spoke, vector);
            first = simd.select_f64s(simd.less_than_f64s(first, number), first, number);
        }
        // The last bits of such a sum are those of the small whole number.
        const ONES: f64 = (1_u64 << 52) as f64;
        let number = (simd.reduce_min_f64s(first) + ONES).to_bits() as u32;
        number.checked_sub(1).map(|lane| lane as usize)
    }

    /// For each lane of a vector: one more than its number if the point at the end of `spoke` is outside, one more than [`LANES`] if it
    /// is within, 0 if it is not sure.
    #[inline(always)]
    fn numbers<S: Simd>(&self, simd: S, spoke: [S::f64s; 3], vector: usize) -> S::f64s {
        const NUMBERS: Lanes = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];
        let at = |row| vectors::<S>(row)[vector];
        let [nx, ny, nz] = &self.normals;
        let height = simd.add_f64s(
            simd.add_f64s(
                simd.mul_f64s(at(nx), spoke[0]),
                simd.mul_f64s(at(ny), spoke[1]),
            ),
            simd.mul_f64s(at(nz), spoke[2]),
        );
        let is_outside = simd.greater_than_f64s(height, at(&self.bounds));
        let within = simd.splat_f64s((LANES + 1) as f64);
        let number = simd.select_f64s(is_outside, at(&NUMBERS), within);
        let is_sure = simd.greater_than_f64s(simd.abs_f64s(height), at(&self.doubts));
        simd.select_f64s(is_sure, number, simd.splat_f64s(0.0))
    }
}

/// The same numbers in vectors.
#[inline(always)]
fn vectors<S: Simd>(row: &[f64]) -> &[S::f64s] {
    S::as_simd_f64s(row).0
}

#[cfg(test)]
mod tests {
    use super::super::plane::{Side, Span};
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// The answers about `p` in vectors as wide as the machine has, and one lane at a time.
    fn answers(fan: &Fan, p: &Point3) -> [Option<usize>; 2] {
        struct Ask<'a>(&'a Fan, &'a Point3);
        impl pulp::WithSimd for Ask<'_> {
            type Output = Option<usize>;
            fn with_simd<S: Simd>(self, simd: S) -> Option<usize> {
                self.0.first_outside(simd, self.1)
            }
        }
        [
            pulp::Arch::new().dispatch(Ask(fan, p)),
            fan.first_outside(pulp::Scalar::new(), p),
        ]
    }

    /// Coordinates on a small lattice, or off it by little, or huge: with all outcomes, and NaN from overflow, which may leave it
    /// open where the planes would not.
    fn point(rng: &mut ChaCha8Rng, scale: f64) -> Point3 {
        [(); 3].map(|()| {
            let off = f64::from(rng.random_range(-1..=1)) * f64::EPSILON;
            (f64::from(rng.random_range(-2..=2)) * 0.3 + off) * scale
        })
    }

    #[test]
    fn a_fan_answers_as_its_planes_do_one_by_one() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let (mut sure, mut unsure) = (0, 0);
        for round in 0..3_000 {
            let scale = [1.0, 1e-200, f64::MAX][round % 3];
            let points: [Point3; 16] = std::array::from_fn(|_| point(&mut rng, scale));
            let span = Span::of(&points);
            let count = 1 + round % LANES;
            let [apex, ref rim @ ..] = points;
            let mut fan = Fan::about(apex);
            let planes: Vec<Plane> = rim
                .windows(2)
                .take(count)
                .map(|edge| Plane::through([apex, edge[0], edge[1]], &span))
                .collect();
            planes.iter().for_each(|plane| fan.push(plane));
            for p in &points {
                let sides: Vec<Side> = planes
                    .iter()
                    .map(|plane| plane.side(plane.height(*p)))
                    .collect();
                let [wide, narrow] = answers(&fan, p);
                assert_eq!(wide, narrow);
                if sides.contains(&Side::Unsure) {
                    unsure += 1;
                    assert_eq!(wide, None);
                } else if let Some(lane) = wide {
                    sure += 1;
                    let first = sides.iter().position(|&side| side == Side::Outside);
                    assert_eq!(lane, first.unwrap_or(LANES));
                } else {
                    assert_eq!(scale, f64::MAX, "only overflow leaves more open");
                }
            }
        }
        assert!(sure > 5_000, "{sure}");
        assert!(unsure > 5_000, "{unsure}");
    }
}
