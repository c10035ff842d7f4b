//! One file a point set.

pub(crate) mod cauchy;
pub(crate) mod circle;
pub(crate) mod collinear;
pub(crate) mod disc;
pub(crate) mod duplicated;
pub(crate) mod killer;
pub(crate) mod lattice;
pub(crate) mod near_collinear;
pub(crate) mod nested_triangles;
pub(crate) mod normal;
pub(crate) mod oblique;
pub(crate) mod parabola;
pub(crate) mod rotated;
pub(crate) mod rounded;
pub(crate) mod shuffled;
pub(crate) mod square;
