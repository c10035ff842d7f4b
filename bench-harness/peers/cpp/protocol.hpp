// The engine's end of the pipe protocol, version 1 (see bench-harness/PROTOCOL.md): include it, derive from
// peer::Engine, call peer::serve in main. Every set of a batch gets an engine of its own.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#ifndef HULLBENCH_OPTIONS
#define HULLBENCH_OPTIONS ""
#endif

namespace peer {

using Clock = std::chrono::steady_clock;

// Points as they came: coordinate by coordinate.
class Points {
public:
  std::string task;
  std::size_t n = 0;
  int dimension = 0;
  std::vector<double> coordinates;

  const double* at(std::size_t i) const { return &coordinates[i * dimension]; }

  // The smallest index of the copies of a point, given by its coordinates.
  std::uint32_t find(const double* point) const {
    if (smallest_.empty()) {
      smallest_.reserve(n);
      for (std::size_t i = 0; i < n; ++i) smallest_.emplace(key(at(i)), i);
    }
    const auto found = smallest_.find(key(point));
    if (found == smallest_.end()) throw std::runtime_error("a vertex of the result is none of the points");
    return found->second;
  }

private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t bits : key) {
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };

  // The bits of the coordinates, the two zeros alike.
  Key key(const double* point) const {
    Key key{};
    for (int i = 0; i < dimension; ++i) {
      const double x = point[i] + 0.0;
      std::memcpy(&key[i], &x, sizeof x);
    }
    return key;
  }

  mutable std::unordered_map<Key, std::uint32_t, Hash> smallest_;
};

// A hull as it leaves: parts of indices. The kinds are those of the protocol.
struct Hull {
  std::string kind;
  std::vector<std::uint32_t> lengths, indices;

  void part(const std::vector<std::uint32_t>& ids) {
    lengths.push_back(ids.size());
    indices.insert(indices.end(), ids.begin(), ids.end());
  }
};

// What computes, with one set of points and its last result. Any std::exception is a refusal, with its text as the
// reason.
class Engine {
public:
  virtual ~Engine() = default;
  virtual std::string version() const = 0;
  virtual std::vector<std::string> tasks() const = 0;
  // Converts to the engine's own type of points: not timed, and done once.
  virtual void load(const Points& points) = 0;
  // Computes, and keeps the result in place of the one before: timed.
  virtual void call() = 0;
  // Frees the result: not timed.
  virtual void forget() = 0;
  // The result as indices, any copy of a point standing for it: not timed.
  virtual Hull hull(const Points& points) = 0;
};

// Makes an engine that has no points yet.
using Make = std::function<std::unique_ptr<Engine>()>;

// Turns a cycle of points of the plane anticlockwise.
inline void anticlockwise(const Points& points, std::vector<std::uint32_t>& cycle) {
  double area = 0;
  for (std::size_t i = 2; i < cycle.size(); ++i) {
    const double *o = points.at(cycle[0]), *a = points.at(cycle[i - 1]), *b = points.at(cycle[i]);
    area += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  }
  if (area < 0) std::reverse(cycle.begin(), cycle.end());
}

namespace detail {

inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + '"';
}

// The text after `"name":` in a flat JSON object.
inline std::string field(const std::string& json, const std::string& name) {
  const std::string label = '"' + name + "\":";
  const std::size_t start = json.find(label);
  if (start == std::string::npos) return "";
  std::size_t from = start + label.size();
  if (json[from] == '"') {
    const std::size_t end = json.find('"', from + 1);
    return json.substr(from + 1, end - from - 1);
  }
  return json.substr(from, json.find_first_of(",}", from) - from);
}

inline unsigned long number(const std::string& json, const std::string& name, const char* otherwise = "0") {
  const std::string digits = field(json, name);
  return std::strtoul(digits.empty() ? otherwise : digits.c_str(), nullptr, 10);
}

// The smallest step of the clock that was seen.
inline long clock_resolution() {
  auto smallest = Clock::duration::max();
  for (int i = 0; i < 1000; ++i) {
    const auto start = Clock::now();
    auto now = start;
    while (now == start) now = Clock::now();
    smallest = std::min(smallest, now - start);
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(smallest).count();
}

// A size from /proc/self/status, in bytes; 0 if it is not there.
inline std::uint64_t status(const std::string& label) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, label.size(), label) == 0) {
      return 1024 * std::strtoull(line.c_str() + label.size(), nullptr, 10);
    }
  }
  return 0;
}

// A size of resident memory without the pages of files, such as code, that are resident now.
inline std::int64_t without_files(const std::string& label) {
  return static_cast<std::int64_t>(status(label)) - static_cast<std::int64_t>(status("RssFile:"));
}

// The rise of resident memory in the first run of the process.
class Peak {
public:
  void begin() {
    if (begun_) return;
    std::ofstream reset("/proc/self/clear_refs");
    reset << "5" << std::flush;
    is_open_ = reset.good();
    before_ = without_files("VmRSS:");
  }
  void end() {
    if (begun_) return;
    begun_ = true;
    bytes_ = static_cast<std::uint64_t>(std::max<std::int64_t>(0, without_files("VmHWM:") - before_));
  }
  bool is_known() const { return begun_ && is_open_; }
  std::uint64_t bytes() const { return bytes_; }

private:
  bool begun_ = false, is_open_ = false;
  std::int64_t before_ = 0;
  std::uint64_t bytes_ = 0;
};

inline std::string receipt(const std::string& name, const Engine& engine) {
  std::ostringstream out;
  out << "{\"protocol\":1,\"engine\":" << quoted(name) << ",\"version\":" << quoted(engine.version())
      << ",\"clock_ns\":" << clock_resolution() << ",\"tasks\":[";
  bool first = true;
  for (const auto& task : engine.tasks()) {
    out << (first ? "" : ",") << quoted(task);
    first = false;
  }
  out << "],\"build\":" << quoted("g++ " __VERSION__ " " HULLBENCH_OPTIONS) << "}";
  return out.str();
}

// A set of points, and the engine that has it.
struct Set {
  Points points;
  std::unique_ptr<Engine> engine;
};

inline std::vector<long long> sample(const std::vector<Set>& sets, unsigned long samples, unsigned long inner) {
  std::vector<long long> nanoseconds;
  for (unsigned long i = 0; i < samples; ++i) {
    for (const Set& set : sets) set.engine->forget();
    const auto start = Clock::now();
    for (unsigned long pass = 0; pass < inner; ++pass) {
      for (const Set& set : sets) set.engine->call();
    }
    const auto time = Clock::now() - start;
    nanoseconds.push_back(std::chrono::duration_cast<std::chrono::nanoseconds>(time).count());
  }
  return nanoseconds;
}

inline void write(const std::vector<std::uint32_t>& numbers) {
  std::cout.write(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint32_t));
}

}  // namespace detail

// Answers commands.
class Server {
public:
  Server(const std::string& name, const Make& make) : name_(name), make_(make) {}

  // Goes on until `quit` or the end of the input.
  int serve() {
    for (std::string line; std::getline(std::cin, line);) {
      const std::string word = line.substr(0, line.find(' '));
      if (word == "quit") break;
      try {
        answer(word, line);
      } catch (const std::exception& error) {
        std::cout << "{\"refused\":" << detail::quoted(error.what()) << "}\n";
      }
      std::cout.flush();
    }
    return 0;
  }

private:
  void answer(const std::string& word, const std::string& line) {
    if (word == "version") {
      std::cout << detail::receipt(name_, *make_()) << '\n';
    } else if (word == "load") {
      load(line);
    } else if (word == "run") {
      run(detail::number(line, "samples"), detail::number(line, "inner"));
    } else if (word == "hull") {
      hull(detail::number(line, "set"));
    } else if (word == "counters") {
      std::cout << "{\"counters\":{";
      if (peak_.is_known()) std::cout << "\"peak_bytes\":" << peak_.bytes();
      std::cout << "}}\n";
    } else {
      throw std::runtime_error("there is no command " + word);
    }
  }

  void load(const std::string& line) {
    sets_.clear();
    has_run_ = false;
    std::vector<detail::Set> sets(detail::number(line, "sets", "1"));
    for (detail::Set& set : sets) read(line, set.points);
    if (sets.empty()) throw std::runtime_error("no sets");
    const std::string task = detail::field(line, "task");
    const auto tasks = make_()->tasks();
    if (std::find(tasks.begin(), tasks.end(), task) == tasks.end()) throw std::runtime_error("does not do " + task);
    if (detail::field(line, "boundary") == "all") throw std::runtime_error("finds extreme points only");
    for (detail::Set& set : sets) {
      set.engine = make_();
      set.engine->load(set.points);
    }
    sets_ = std::move(sets);
    std::cout << "{\"loaded\":" << sets_[0].points.n << ",\"sets\":" << sets_.size() << "}\n";
  }

  static void read(const std::string& line, Points& points) {
    points.task = detail::field(line, "task");
    points.n = detail::number(line, "n");
    points.dimension = detail::number(line, "dimension");
    points.coordinates.resize(points.n * points.dimension);
    const std::size_t bytes = points.coordinates.size() * sizeof(double);
    std::cin.read(reinterpret_cast<char*>(points.coordinates.data()), bytes);
  }

  void run(unsigned long samples, unsigned long inner) {
    if (sets_.empty()) throw std::runtime_error("no points were loaded");
    if (samples == 0 || inner == 0) throw std::runtime_error("nothing to run");
    has_run_ = false;
    peak_.begin();
    const auto nanoseconds = detail::sample(sets_, samples, inner);
    peak_.end();
    has_run_ = true;
    std::cout << "{\"nanoseconds\":[";
    for (std::size_t i = 0; i < nanoseconds.size(); ++i) std::cout << (i ? "," : "") << nanoseconds[i];
    std::cout << "]}\n";
  }

  void hull(unsigned long number) {
    if (!has_run_) throw std::runtime_error("nothing was run");
    if (number >= sets_.size()) throw std::runtime_error("there is no set " + std::to_string(number));
    const detail::Set& set = sets_[number];
    Hull hull = set.engine->hull(set.points);
    for (std::uint32_t& id : hull.indices) id = set.points.find(set.points.at(id));
    std::cout << "{\"kind\":" << detail::quoted(hull.kind) << ",\"lengths\":" << hull.lengths.size()
              << ",\"indices\":" << hull.indices.size() << "}\n";
    detail::write(hull.lengths);
    detail::write(hull.indices);
  }

  std::string name_;
  Make make_;
  std::vector<detail::Set> sets_;
  detail::Peak peak_;
  bool has_run_ = false;
};

// Answers commands as the engine `name`; what main returns.
inline int serve(const std::string& name, const Make& make) {
  std::ios::sync_with_stdio(false);
  return Server(name, make).serve();
}

}  // namespace peer
