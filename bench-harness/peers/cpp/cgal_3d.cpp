// CGAL's spatial hull, into a Surface_mesh. Its triangles may be coplanar; its vertices are the extreme points. CGAL
// gives no indices; they are found by coordinates afterwards.

#include "protocol.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

class Cgal : public peer::Engine {
public:
  std::string version() const override { return CGAL_VERSION_STR; }
  std::vector<std::string> tasks() const override { return {"hull3"}; }

  void load(const peer::Points& points) override {
    input_.reserve(points.n);
    for (std::size_t i = 0; i < points.n; ++i) {
      const double* p = points.at(i);
      input_.emplace_back(p[0], p[1], p[2]);
    }
    if (points.n < 4) throw std::runtime_error("needs four points that span space");
  }

  void call() override {
    Mesh result;
    CGAL::convex_hull_3(input_.begin(), input_.end(), result);
    result_ = std::move(result);
  }

  void forget() override { result_ = Mesh(); }

  // The result for points in a plane is an open surface, whose border is their hull.
  peer::Hull hull(const peer::Points& points) override {
    for (const auto halfedge : result_.halfedges()) {
      if (result_.is_border(halfedge)) return border(points, halfedge);
    }
    if (result_.number_of_faces() == 0) throw std::runtime_error("the result has no facets");
    peer::Hull hull{"triangles", {}, {}};
    for (const auto face : result_.faces()) {
      std::vector<std::uint32_t> corners;
      for (const auto vertex : result_.vertices_around_face(result_.halfedge(face))) {
        corners.push_back(find(points, vertex));
      }
      hull.part(corners);
    }
    return hull;
  }

private:
  peer::Hull border(const peer::Points& points, Mesh::Halfedge_index start) const {
    std::vector<std::uint32_t> corners;
    auto at = start;
    do {
      corners.push_back(find(points, result_.target(at)));
      at = result_.next(at);
    } while (at != start);
    peer::Hull hull{"facets", {}, {}};
    hull.part(corners);
    return hull;
  }

  std::uint32_t find(const peer::Points& points, Mesh::Vertex_index vertex) const {
    const Point& p = result_.point(vertex);
    const double coordinates[] = {p.x(), p.y(), p.z()};
    return points.find(coordinates);
  }

  std::vector<Point> input_;
  Mesh result_;
};

int main() {
  return peer::serve("cgal-3d", std::make_unique<Cgal>);
}
