//! The list of outside programs.

use super::Need::{Command, Header};
use super::{Need, Peer, Program, Recipe};
use crate::engine::protocol::Problem::{self, Delaunay, Hull2, Hull3};

const COMPILER: Need = Command {
    program: "g++",
    variable: "CXX",
    package: "g++",
};

const CGAL: Need = Header {
    header: "CGAL/version.h",
    package: "libcgal-dev",
};

/// CGAL's own build files ask for this option: its interval arithmetic changes the rounding mode.
const ROUNDING: &[&str] = &["-frounding-math"];

/// What CGAL's exact numbers are made of.
const NUMBERS: &[&str] = &["-lmpfr", "-lgmp"];

const PLANE: &[Problem] = &[Hull2];
const SPACE: &[Problem] = &[Hull3];

/// Every outside program.
pub const PROGRAMS: &[Program] = &[
    Program {
        name: "qhull",
        recipe: Recipe::Cpp {
            options: &[],
            libraries: &["-lqhull_r"],
        },
        sources: &["cpp/qhull.cpp", "cpp/protocol.hpp"],
        needs: &[
            COMPILER,
            Header {
                header: "libqhull_r/qhull_ra.h",
                package: "libqhull-dev",
            },
        ],
        engines: &[Peer {
            name: "qhull",
            problems: &[Hull2, Hull3, Delaunay],
            about: "Qhull (libqhull_r), option Qt. Not exact: merges facets, and refuses flat input.",
        }],
    },
    Program {
        name: "cgal-2d",
        recipe: Recipe::Cpp {
            options: ROUNDING,
            libraries: NUMBERS,
        },
        sources: &["cpp/cgal_2d.cpp", "cpp/protocol.hpp"],
        needs: &[COMPILER, CGAL],
        engines: &[
            Peer {
                name: "cgal-convex-hull-2",
                problems: PLANE,
                about: "CGAL convex_hull_2: what CGAL takes by default. Exact.",
            },
            Peer {
                name: "cgal-akl-toussaint",
                problems: PLANE,
                about: "CGAL ch_akl_toussaint: a quadrilateral of extremes, then a scan. Exact.",
            },
            Peer {
                name: "cgal-bykat",
                problems: PLANE,
                about: "CGAL ch_bykat: quickhull without recursion. Exact.",
            },
            Peer {
                name: "cgal-eddy",
                problems: PLANE,
                about: "CGAL ch_eddy: quickhull on lists. Exact.",
            },
            Peer {
                name: "cgal-graham-andrew",
                problems: PLANE,
                about: "CGAL ch_graham_andrew: sort by x, then a scan. Exact.",
            },
            Peer {
                name: "cgal-jarvis",
                problems: PLANE,
                about: "CGAL ch_jarvis: gift wrapping, O(n h). Exact.",
            },
        ],
    },
    Program {
        name: "cgal-3d",
        recipe: Recipe::Cpp {
            options: ROUNDING,
            libraries: NUMBERS,
        },
        sources: &["cpp/cgal_3d.cpp", "cpp/protocol.hpp"],
        needs: &[COMPILER, CGAL],
        engines: &[Peer {
            name: "cgal-3d",
            problems: SPACE,
            about: "CGAL convex_hull_3 into a Surface_mesh. Exact.",
        }],
    },
    Program {
        name: "cgal-delaunay",
        recipe: Recipe::Cpp {
            options: ROUNDING,
            libraries: NUMBERS,
        },
        sources: &["cpp/cgal_delaunay.cpp", "cpp/protocol.hpp"],
        needs: &[COMPILER, CGAL],
        engines: &[Peer {
            name: "cgal-delaunay",
            problems: &[Delaunay],
            about: "CGAL Delaunay_triangulation_2 with spatial sorting. Exact.",
        }],
    },
    Program {
        name: "boost-geometry",
        recipe: Recipe::Cpp {
            options: &[],
            libraries: &[],
        },
        sources: &["cpp/boost_geometry.cpp", "cpp/protocol.hpp"],
        needs: &[
            COMPILER,
            Header {
                header: "boost/geometry.hpp",
                package: "libboost-dev",
            },
        ],
        engines: &[Peer {
            name: "boost-geometry",
            problems: PLANE,
            about: "Boost.Geometry convex_hull. Not exact: its side test has an epsilon.",
        }],
    },
    Program {
        name: "geos",
        recipe: Recipe::Cpp {
            options: &[],
            libraries: &["-lgeos_c"],
        },
        sources: &["cpp/geos.cpp", "cpp/protocol.hpp"],
        needs: &[
            COMPILER,
            Header {
                header: "geos_c.h",
                package: "libgeos-dev",
            },
        ],
        engines: &[Peer {
            name: "geos",
            problems: PLANE,
            about: "GEOS ConvexHull through its C interface.",
        }],
    },
    Program {
        name: "scipy",
        recipe: Recipe::Python {
            modules: &["numpy", "scipy.spatial"],
        },
        sources: &["python/scipy_peer.py", "python/protocol.py"],
        needs: &[Command {
            program: "python3",
            variable: "HULLBENCH_PYTHON",
            package: "python3",
        }],
        engines: &[Peer {
            name: "scipy",
            problems: &[Hull2, Hull3, Delaunay],
            about: "SciPy ConvexHull and Delaunay, which are Qhull as most people meet it.",
        }],
    },
    Program {
        name: "rust-crates",
        recipe: Recipe::Cargo,
        sources: &[
            "rust/src/main.rs",
            "rust/src/protocol.rs",
            "rust/src/crates.rs",
            "rust/Cargo.toml",
            "rust/Cargo.lock",
        ],
        needs: &[Command {
            program: "cargo",
            variable: "CARGO",
            package: "cargo",
        }],
        engines: &[
            Peer {
                name: "geo-quick-hull",
                problems: PLANE,
                about: "geo quick_hull: exact side test, rounded choice of the farthest point.",
            },
            Peer {
                name: "geo-graham-hull",
                problems: PLANE,
                about: "geo graham_hull: exact within the range of its predicates.",
            },
            Peer {
                name: "parry2d",
                problems: PLANE,
                about: "parry2d-f64 convex_hull_idx. Not exact.",
            },
            Peer {
                name: "parry3d",
                problems: SPACE,
                about: "parry3d-f64 try_convex_hull. Not exact.",
            },
            Peer {
                name: "chull",
                problems: &[Hull2, Hull3],
                about: "chull ConvexHull with its default threshold. Not exact.",
            },
            Peer {
                name: "spade",
                problems: &[Delaunay],
                about: "spade DelaunayTriangulation by bulk_load. Exact within the range it accepts.",
            },
            Peer {
                name: "delaunator",
                problems: &[Delaunay],
                about: "delaunator triangulate. Its in-circle test is rounded.",
            },
        ],
    },
];
