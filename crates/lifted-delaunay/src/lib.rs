//! Delaunay triangulations as lower hulls of points lifted to the paraboloid.
