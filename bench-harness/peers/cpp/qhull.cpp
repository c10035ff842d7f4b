// Qhull through its reentrant library: hulls in the plane and in space, Delaunay triangulations. Option Qt has it cut
// merged facets into triangles.

#include "protocol.hpp"

#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

// A computation, freed with both of Qhull's kinds of memory.
class Computation {
public:
  Computation(int dimension, std::vector<double>& points, const std::string& options) {
    qh_zero(&qh_, stderr);
    std::string command = "qhull " + options;
    code_ = qh_new_qhull(&qh_, dimension, points.size() / dimension, points.data(), False, &command[0], nullptr, stderr);
  }
  ~Computation() {
    qh_freeqhull(&qh_, !qh_ALL);
    int left, total;
    qh_memfreeshort(&qh_, &left, &total);
  }
  Computation(const Computation&) = delete;
  Computation& operator=(const Computation&) = delete;

  qhT* get() { return &qh_; }
  int code() const { return code_; }

private:
  qhT qh_;
  int code_;
};

class Qhull : public peer::Engine {
public:
  std::string version() const override { return qh_version2; }
  std::vector<std::string> tasks() const override { return {"hull2", "hull3", "delaunay"}; }

  void load(const peer::Points& points) override {
    if (points.n == 0) throw std::runtime_error("needs points");
    dimension_ = points.dimension;
    input_ = points.coordinates;
    options_ = points.task == "delaunay" ? "d Qt Qbb Pp" : "Qt Pp";
  }

  void call() override {
    result_.reset();
    result_ = std::make_unique<Computation>(dimension_, input_, options_);
    if (result_->code() != 0) throw std::runtime_error(explanation(result_->code()));
  }

  void forget() override { result_.reset(); }

  peer::Hull hull(const peer::Points& points) override {
    return points.task == "hull2" ? cycle(points) : triangles(points.task == "delaunay");
  }

private:
  static std::string explanation(int code) {
    static const std::map<int, std::string> WORDS = {{qh_ERRinput, "input that it does not take"},
                                                     {qh_ERRsingular, "flat input"},
                                                     {qh_ERRprec, "precision"},
                                                     {qh_ERRmem, "memory"}};
    const auto words = WORDS.find(code);
    return "Qhull error " + std::to_string(code) + ": " + (words == WORDS.end() ? "internal" : words->second);
  }

  // In the plane a facet is an edge; from each vertex go on to the neighbour one does not come from.
  peer::Hull cycle(const peer::Points& points) {
    qhT* qh = result_->get();
    std::map<std::uint32_t, std::vector<std::uint32_t>> neighbours;
    facetT* facet;
    FORALLfacets {
      const std::uint32_t a = id(SETfirstt_(facet->vertices, vertexT));
      const std::uint32_t b = id(SETsecondt_(facet->vertices, vertexT));
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
    std::vector<std::uint32_t> cycle;
    const std::uint32_t first = neighbours.begin()->first;
    std::uint32_t from = first, at = first;
    do {
      const auto& next = neighbours.at(at);
      if (next.size() != 2) throw std::runtime_error("the edges of the result are no cycle");
      cycle.push_back(at);
      const std::uint32_t to = next[0] == from ? next[1] : next[0];
      from = at;
      at = to;
    } while (at != first);
    peer::anticlockwise(points, cycle);
    peer::Hull hull{"cycle", {}, {}};
    hull.part(cycle);
    return hull;
  }

  // Qhull orders the corners of a facet clockwise seen from outside, hence from below anticlockwise seen from above.
  peer::Hull triangles(bool is_delaunay) {
    qhT* qh = result_->get();
    peer::Hull hull{"triangles", {}, {}};
    facetT* facet;
    FORALLfacets {
      if (is_delaunay && facet->upperdelaunay) continue;
      setT* corners = qh_facet3vertex(qh, facet);
      std::vector<std::uint32_t> ids;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(corners) ids.push_back(id(vertex));
      qh_settempfree(qh, &corners);
      if (!is_delaunay) std::reverse(ids.begin(), ids.end());
      hull.part(ids);
    }
    return hull;
  }

  std::uint32_t id(const vertexT* vertex) { return qh_pointid(result_->get(), vertex->point); }

  int dimension_ = 0;
  std::vector<double> input_;
  std::string options_;
  std::unique_ptr<Computation> result_;
};

int main() {
  return peer::serve("qhull", std::make_unique<Qhull>);
}
