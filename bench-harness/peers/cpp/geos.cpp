// GEOS through its C interface: the hull of a line through the points, which is the cheapest geometry to hand over.

#include "protocol.hpp"

#include <geos_c.h>

class Geos : public peer::Engine {
public:
  Geos() : geos_(GEOS_init_r()) {}
  ~Geos() override {
    forget();
    GEOSGeom_destroy_r(geos_, input_);
    GEOS_finish_r(geos_);
  }

  std::string version() const override { return GEOSversion(); }
  std::vector<std::string> tasks() const override { return {"hull2"}; }

  void load(const peer::Points& points) override {
    if (points.n < 2) throw std::runtime_error("a line needs two points");
    GEOSCoordSequence* line = GEOSCoordSeq_create_r(geos_, points.n, 2);
    for (std::size_t i = 0; i < points.n; ++i) {
      GEOSCoordSeq_setXY_r(geos_, line, i, points.at(i)[0], points.at(i)[1]);
    }
    input_ = GEOSGeom_createLineString_r(geos_, line);
    if (input_ == nullptr) throw std::runtime_error("GEOS takes no such line");
  }

  void call() override {
    forget();
    result_ = GEOSConvexHull_r(geos_, input_);
    if (result_ == nullptr) throw std::runtime_error("GEOS gave no hull");
  }

  void forget() override {
    GEOSGeom_destroy_r(geos_, result_);
    result_ = nullptr;
  }

  peer::Hull hull(const peer::Points& points) override {
    const bool is_polygon = GEOSGeomTypeId_r(geos_, result_) == GEOS_POLYGON;
    const GEOSGeometry* outline = is_polygon ? GEOSGetExteriorRing_r(geos_, result_) : result_;
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos_, outline);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(geos_, sequence, &size);
    // A ring says its first vertex again at its end.
    if (is_polygon) --size;
    std::vector<std::uint32_t> cycle;
    for (unsigned i = 0; i < size; ++i) {
      double coordinates[2];
      GEOSCoordSeq_getXY_r(geos_, sequence, i, &coordinates[0], &coordinates[1]);
      cycle.push_back(points.find(coordinates));
    }
    peer::anticlockwise(points, cycle);
    peer::Hull hull{"cycle", {}, {}};
    hull.part(cycle);
    return hull;
  }

private:
  GEOSContextHandle_t geos_;
  GEOSGeometry *input_ = nullptr, *result_ = nullptr;
};

int main() {
  return peer::serve("geos", std::make_unique<Geos>);
}
