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
    input_.clear();
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

  // Flat sets have one polygon; everything else has triangles.
  peer::Hull hull(const peer::Points& points) override {
    std::vector<double> wanted;
    std::vector<std::uint32_t> lengths;
    for (const auto face : result_.faces()) {
      std::uint32_t length = 0;
      for (const auto vertex : result_.vertices_around_face(result_.halfedge(face))) {
        const Point& p = result_.point(vertex);
        wanted.insert(wanted.end(), {p.x(), p.y(), p.z()});
        ++length;
      }
      lengths.push_back(length);
    }
    if (lengths.empty()) throw std::runtime_error("the result has no facets");
    const bool is_solid = lengths.size() > 3 && lengths == std::vector<std::uint32_t>(lengths.size(), 3);
    return {is_solid ? "triangles" : "facets", lengths, peer::Finder(points).indices(wanted)};
  }

private:
  std::vector<Point> input_;
  Mesh result_;
};

int main() {
  Cgal engine;
  return peer::serve("cgal-3d", engine);
}
