// Measures the undecided band between the hardest step that a search solves and the easiest one
// that the reach bound proves impossible. One row for each kind of step, in studs:
//   {"name":"gap","solvedTo":11.4,"unreachableFrom":11.9,"band":0.5}
//   bench_band [--json] [--steps N]     N: simulated ticks for each attempt of the search
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>

#include "io/json_writer.h"
#include "solve/proof/reach_bound.h"
#include "support/hardest_step.h"

namespace {

using namespace obby;
using namespace obby::support;

struct Case {
  const char* name;
  float solved, wide;  // sizes of a step that is certainly solved, and of one that certainly is not
  Build build;
};

bool isShown(const Case& c, float studs) {
  Scene scene = c.build(studs);
  const level::Level level = scene.level.compile();
  const Problem problem = plainProblem(level, queryFor(scene));
  for (const uint32_t id : solve::ReachBound(problem, true).reached()) {
    if (level.view().colliders[id].part == kTarget) return false;
  }
  return true;
}

// Returns the last value for which `holds` is true. holds(lo) must be true and holds(hi) false.
template <class Holds>
float bisect(float lo, float hi, float resolution, Holds&& holds) {
  while (hi - lo > resolution) {
    const float middle = 0.5f * (lo + hi);
    (holds(middle) ? lo : hi) = middle;
  }
  return lo;
}

}  // namespace

int main(int argc, char** argv) {
  uint64_t steps = 2'000'000;
  bool json = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) {
      json = true;
    } else if (std::strcmp(argv[i], "--steps") == 0 && i + 1 < argc) {
      steps = std::strtoull(argv[++i], nullptr, 10);
    } else {
      fmt::print(stderr, "usage: bench_band [--json] [--steps N]\n");
      return 2;
    }
  }
  const Case cases[] = {
      {"gap", 8, 30, [](float x) { return platforms(x, 0); }},
      {"ledge", 6, 30, [](float x) { return platforms(0, x); }},
      {"drop", 8, 40, [](float x) { return platforms(x, -8); }},
      {"off across", 6, 40,
       [](float x) {
         return off({8, 0, 0}, x);
       }},
      {"off along", 6, 40,
       [](float x) {
         return off({0, 0, -8}, x);
       }},
      {"off pushed", 6, 40,
       [](float x) {
         return off({0, 0, -8}, x, false);
       }},
      {"off lift", 6, 40,
       [](float x) {
         return off({0, 8, 0}, x);
       }},
      {"onto across", 6, 40,
       [](float x) {
         return onto({8, 0, 0}, x);
       }},
      {"onto along", 6, 40,
       [](float x) {
         return onto({0, 0, -8}, x);
       }},
      {"onto lift", 6, 40,
       [](float x) {
         return onto({0, 8, 0}, x);
       }},
  };
  for (const Case& c : cases) {
    const float from = bisect(c.solved, c.wide, 0.01f, [&](float x) { return !isShown(c, x); });
    const float to = hardestSolved(c.build, c.solved, from, steps);
    if (json) {
      io::JsonWriter line;
      line.open('{').field("name", c.name).key("solvedTo").raw(fmt::format("{:.2f}", to));
      line.key("unreachableFrom").raw(fmt::format("{:.2f}", from));
      fmt::print("{}\n", line.key("band").raw(fmt::format("{:.2f}", from - to)).finish());
    } else {
      fmt::print("{:12} solved to {:6.2f}  unreachable from {:6.2f}  band {:5.2f}\n", c.name, to,
                 from, from - to);
    }
    std::fflush(stdout);
  }
  return 0;
}
