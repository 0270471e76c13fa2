#include "solve/search/way_identity.h"

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

bool samePath(const Way& a, const Way& b) {
  return !pathsDiffer(a.playthrough.path, b.playthrough.path, kDistinct);
}

// Returns true if removing one part of `longer` makes it equal to `shorter`.
bool oneMore(const std::vector<int32_t>& longer, const std::vector<int32_t>& shorter) {
  if (longer.size() != shorter.size() + 1) return false;
  const auto [l, s] = std::mismatch(longer.begin(), longer.end(), shorter.begin(), shorter.end());
  return std::equal(l + 1, longer.end(), s, shorter.end());
}

bool sameRoute(const Way& a, const Way& b) {
  return a.route == b.route || oneMore(a.route, b.route) || oneMore(b.route, a.route);
}

}  // namespace

bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance) {
  return strays(a, b, distance) || strays(b, a, distance);
}

void noteRoute(const Problem& problem, Way& way) {
  if (way.route.empty()) way.route = directRouteOf(problem, courseOf(problem, way.playthrough));
}

const WayIdentity& byPath() {
  static const WayIdentity identity{nullptr, samePath, false};
  return identity;
}

const WayIdentity& byRoute() {
  static const WayIdentity identity{noteRoute, sameRoute, true};
  return identity;
}

}  // namespace obby::solve
