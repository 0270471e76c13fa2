#include "solve/search/solution_identity.h"

#include <algorithm>

#include "solve/model/route.h"

namespace obby::solve {

namespace {

bool strays(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance) {
  return std::any_of(a.begin(), a.end(), [&](Vec3 p) {
    return std::none_of(b.begin(), b.end(), [&](Vec3 q) {
      const Vec3 d = p - q;
      return dot(d, d) <= distance * distance;
    });
  });
}

bool samePath(const Solution& a, const Solution& b) {
  return !pathsDiffer(a.trajectory.path, b.trajectory.path, kDistinct);
}

// Returns true if removing one part of `longer` makes it equal to `shorter`.
bool oneMore(const std::vector<int32_t>& longer, const std::vector<int32_t>& shorter) {
  if (longer.size() != shorter.size() + 1) return false;
  const auto [l, s] = std::mismatch(longer.begin(), longer.end(), shorter.begin(), shorter.end());
  return std::equal(l + 1, longer.end(), s, shorter.end());
}

bool sameRoute(const Solution& a, const Solution& b) {
  return a.route == b.route || oneMore(a.route, b.route) || oneMore(b.route, a.route);
}

}  // namespace

bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance) {
  return strays(a, b, distance) || strays(b, a, distance);
}

void noteRoute(const Problem& problem, Solution& solution) {
  if (solution.route.empty())
    solution.route = directRouteOf(problem, courseOf(problem, solution.trajectory));
}

const SolutionIdentity& byPath() {
  static const SolutionIdentity identity{nullptr, samePath, false};
  return identity;
}

const SolutionIdentity& byRoute() {
  static const SolutionIdentity identity{noteRoute, sameRoute, true};
  return identity;
}

}  // namespace obby::solve
