// Measures the value of each part of the policy's observation by training without it, and the value
// of other observations.
#include <utility>

#include "common/learning.h"
#include "views/other_views.h"

namespace {

using namespace obby;

struct Range {
  int first, count;  // input indices
};

// Trains a policy without these inputs.
bench::LearningRow without(const char* name, std::vector<Range> hidden) {
  return {name, [hidden = std::move(hidden)](train::TrainerSettings& settings) {
            for (const Range& range : hidden) {
              for (int i = 0; i < range.count; ++i) settings.hidden.push_back(range.first + i);
            }
          }};
}

// Trains a policy with another observation.
bench::LearningRow seeing(const char* name, policy::Observe observe) {
  return {name,
          [observe](train::TrainerSettings& settings) { settings.envGroup.observe = observe; }};
}

constexpr int mapAt(int map) { return policy::kMapsAt + map * policy::kPoints; }

// Returns one ring of all maps.
std::vector<Range> ring(int number) {
  std::vector<Range> out;
  for (int map = 0; map < policy::kMaps; ++map)
    out.push_back({mapAt(map) + 1 + number * policy::kDirections, policy::kDirections});
  return out;
}

// Returns every other direction of all maps.
std::vector<Range> halfOfDirections() {
  std::vector<Range> out;
  for (int map = 0; map < policy::kMaps; ++map) {
    for (int i = 1; i < policy::kDirections * policy::kRings; i += 2)
      out.push_back({mapAt(map) + 1 + i, 1});
  }
  return out;
}

// lib/policy/observation.h numbers the inputs.
std::vector<bench::LearningRow> rows() {
  const Range floors{mapAt(0), policy::kPoints}, dangers{mapAt(1), policy::kPoints};
  const Range floorsSoon{mapAt(2), policy::kPoints}, dangersSoon{mapAt(3), policy::kPoints};
  return {
      without("all", {}),
      seeing("rays", bench::rays),
      seeing("nearestParts", bench::nearestParts),
      seeing("partSet", bench::partSet),
      without("noVelocity", {{0, 3}}),
      without("noFloorAndState", {{3, 9}}),
      without("noWayToRegion", {{12, 6}}),
      without("noFacing", {{18, 2}}),
      without("noLimits", {{20, 2}}),
      without("noHealthAndPace", {{22, 4}}),
      without("noLooseBody", {{policy::kStateInputs, policy::kBodyInputs}}),
      without("noFloorsNow", {floors}),
      without("noFloorsSoon", {floorsSoon}),
      without("noDangersNow", {dangers}),
      without("noDangersSoon", {dangersSoon}),
      without("noSoon", {floorsSoon, dangersSoon}),
      without("noDangers", {dangers, dangersSoon}),
      without("noMaps", {{mapAt(0), policy::kMaps * policy::kPoints}}),
      without("noInnermostRing", ring(0)),
      without("noOutermostRing", ring(policy::kRings - 1)),
      without("halfOfDirections", halfOfDirections()),
  };
}

}  // namespace

int main(int argc, char** argv) { return bench::learningBench(argc, argv, "observation", rows()); }
