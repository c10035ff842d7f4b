// CGAL's Delaunay triangulation of points of the plane, inserted in the order of its spatial sort. CGAL gives no
// indices; they are found by coordinates afterwards.

#include "protocol.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <memory>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

class Cgal : public peer::Engine {
public:
  std::string version() const override { return CGAL_VERSION_STR; }
  std::vector<std::string> tasks() const override { return {"delaunay"}; }

  void load(const peer::Points& points) override {
    input_.reserve(points.n);
    for (std::size_t i = 0; i < points.n; ++i) input_.emplace_back(points.at(i)[0], points.at(i)[1]);
  }

  void call() override {
    result_ = std::make_unique<Triangulation>(input_.begin(), input_.end());
  }

  void forget() override { result_.reset(); }

  peer::Hull hull(const peer::Points& points) override {
    peer::Hull hull{"triangles", {}, {}};
    for (const auto face : result_->finite_face_handles()) {
      for (int i = 0; i < 3; ++i) hull.indices.push_back(find(points, face->vertex(i)->point()));
      hull.lengths.push_back(3);
    }
    return hull;
  }

private:
  static std::uint32_t find(const peer::Points& points, const Point& p) {
    const double coordinates[] = {p.x(), p.y()};
    return points.find(coordinates);
  }

  std::vector<Point> input_;
  std::unique_ptr<Triangulation> result_;
};

int main() {
  return peer::serve("cgal-delaunay", std::make_unique<Cgal>);
}
