// CGAL's planar hulls: cgal-convex-hull-2, cgal-akl-toussaint, cgal-bykat, cgal-eddy, cgal-graham-andrew, cgal-jarvis.
//
// Points in a vector in, points in a vector out, with exact predicates and inexact constructions. CGAL gives no
// indices; they are found by coordinates afterwards.

#include "protocol.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ch_akl_toussaint.h>
#include <CGAL/ch_bykat.h>
#include <CGAL/ch_eddy.h>
#include <CGAL/ch_graham_andrew.h>
#include <CGAL/ch_jarvis.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/version.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Input = std::vector<Point>;
using Output = std::back_insert_iterator<Input>;
using Method = void (*)(const Input&, Output);

#define METHOD(function) [](const Input& in, Output out) { CGAL::function(in.begin(), in.end(), out); }

static const std::map<std::string, Method> METHODS = {
    {"cgal-convex-hull-2", METHOD(convex_hull_2)}, {"cgal-akl-toussaint", METHOD(ch_akl_toussaint)},
    {"cgal-bykat", METHOD(ch_bykat)},              {"cgal-eddy", METHOD(ch_eddy)},
    {"cgal-graham-andrew", METHOD(ch_graham_andrew)}, {"cgal-jarvis", METHOD(ch_jarvis)},
};

class Cgal : public peer::Engine {
public:
  explicit Cgal(Method method) : method_(method) {}

  std::string version() const override { return CGAL_VERSION_STR; }
  std::vector<std::string> tasks() const override { return {"hull2"}; }

  void load(const peer::Points& points) override {
    input_.reserve(points.n);
    for (std::size_t i = 0; i < points.n; ++i) input_.emplace_back(points.at(i)[0], points.at(i)[1]);
  }

  void call() override {
    Input result;
    method_(input_, std::back_inserter(result));
    result_ = std::move(result);
  }

  void forget() override { Input().swap(result_); }

  peer::Hull hull(const peer::Points& points) override {
    std::vector<std::uint32_t> cycle;
    for (const Point& p : result_) {
      const double coordinates[] = {p.x(), p.y()};
      cycle.push_back(points.find(coordinates));
    }
    peer::Hull hull{"cycle", {}, {}};
    hull.part(cycle);
    return hull;
  }

private:
  Method method_;
  Input input_, result_;
};

int main(int count, char** arguments) {
  const auto method = METHODS.find(count > 1 ? arguments[1] : "");
  if (method == METHODS.end()) {
    std::cerr << "usage: cgal-2d ENGINE\n";
    return 2;
  }
  return peer::serve(method->first, [method] { return std::make_unique<Cgal>(method->second); });
}
