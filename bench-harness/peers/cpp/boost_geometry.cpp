// Boost.Geometry's convex_hull of a multi_point. It gives no indices; they are found by coordinates afterwards.

#include "protocol.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

namespace geometry = boost::geometry;
using Point = geometry::model::d2::point_xy<double>;
// Anticlockwise, and the first vertex not said again at the end.
using Polygon = geometry::model::polygon<Point, false, false>;

class Boost : public peer::Engine {
public:
  std::string version() const override {
    return std::to_string(BOOST_VERSION / 100000) + '.' + std::to_string(BOOST_VERSION / 100 % 1000) + '.' +
           std::to_string(BOOST_VERSION % 100);
  }
  std::vector<std::string> tasks() const override { return {"hull2"}; }

  void load(const peer::Points& points) override {
    input_.reserve(points.n);
    for (std::size_t i = 0; i < points.n; ++i) input_.emplace_back(points.at(i)[0], points.at(i)[1]);
  }

  void call() override {
    Polygon result;
    geometry::convex_hull(input_, result);
    result_ = std::move(result);
  }

  void forget() override { result_ = Polygon(); }

  peer::Hull hull(const peer::Points& points) override {
    std::vector<std::uint32_t> cycle;
    for (const Point& p : result_.outer()) {
      const double coordinates[] = {p.x(), p.y()};
      cycle.push_back(points.find(coordinates));
    }
    // A ring of one or two points says the first again, to have three.
    while (cycle.size() > 1 && cycle.back() == cycle.front()) cycle.pop_back();
    peer::Hull hull{"cycle", {}, {}};
    hull.part(cycle);
    return hull;
  }

private:
  geometry::model::multi_point<Point> input_;
  Polygon result_;
};

int main() {
  return peer::serve("boost-geometry", std::make_unique<Boost>);
}
