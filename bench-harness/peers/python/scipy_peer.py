"""SciPy's ConvexHull and Delaunay with their default options."""

import sys

import numpy as np
import scipy
from scipy.spatial import ConvexHull, Delaunay

import protocol


class Scipy:
    version = scipy.__version__
    tasks = ["hull2", "hull3", "delaunay"]

    def load(self, task, points):
        self.points = np.ascontiguousarray(points)
        self.compute = Delaunay if task == "delaunay" else ConvexHull

    def call(self):
        return self.compute(self.points)

    def hull(self, task, points, result):
        if task == "hull2":
            return "cycle", [result.vertices]
        triangles = result.simplices.astype(np.int64)
        a, b, c = (points[triangles[:, corner]] for corner in range(3))
        if task == "hull3":
            # Simplices come in any orientation; the equations have the outward normals.
            turn = np.einsum("ij,ij->i", np.cross(b - a, c - a), result.equations[:, :3])
        else:
            turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        clockwise = turn < 0
        triangles[clockwise] = triangles[clockwise][:, [0, 2, 1]]
        return "triangles", triangles


if __name__ == "__main__":
    protocol.serve(sys.argv[1] if len(sys.argv) > 1 else "scipy", Scipy)
