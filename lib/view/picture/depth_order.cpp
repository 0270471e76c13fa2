#include "view/picture/depth_order.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "geom/shapes/table.h"

namespace obby::view {

namespace {

constexpr float kRayStart = 1e4f;    // studs from the paper to the rays' origins
constexpr float kSameDepth = 1e-2f;  // studs
constexpr float kMinOverlap = 0.5f;  // pixels on each axis

struct Bounds {
  Vec2 lo{1e30f, 1e30f}, hi{-1e30f, -1e30f};
};

Bounds boundsOf(const std::vector<Vec2>& points) {
  Bounds out;
  for (const Vec2 p : points) {
    out.lo = {std::min(out.lo.x, p.x), std::min(out.lo.y, p.y)};
    out.hi = {std::max(out.hi.x, p.x), std::max(out.hi.y, p.y)};
  }
  return out;
}

bool overlap(const Bounds& a, const Bounds& b) {
  return std::min(a.hi.x, b.hi.x) - std::max(a.lo.x, b.lo.x) > kMinOverlap &&
         std::min(a.hi.y, b.hi.y) - std::max(a.lo.y, b.lo.y) > kMinOverlap;
}

// Returns twice the signed area of the triangle a b c.
float turnOf(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Cuts off the part of a convex polygon to the right of the line from a to b.
std::vector<Vec2> cutBy(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b) {
  std::vector<Vec2> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const float atP = turnOf(a, b, p), atQ = turnOf(a, b, q);
    if (atP >= 0) out.push_back(p);
    if ((atP >= 0) == (atQ >= 0)) continue;
    const float share = atP / (atP - atQ);
    out.push_back({p.x + (q.x - p.x) * share, p.y + (q.y - p.y) * share});
  }
  return out;
}

// Returns a point inside both outlines, which go round in the order of convexHull().
std::optional<Vec2> sharedPoint(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  std::vector<Vec2> shared = a;
  for (size_t i = 0; i < b.size() && !shared.empty(); ++i)
    shared = cutBy(shared, b[i], b[(i + 1) % b.size()]);
  const Bounds bounds = boundsOf(shared);
  if (shared.size() < 3 || !overlap(bounds, bounds)) return {};
  Vec2 sum{0, 0};
  for (const Vec2 p : shared) sum = {sum.x + p.x, sum.y + p.y};
  return Vec2{sum.x / float(shared.size()), sum.y / float(shared.size())};
}

std::optional<float> depthAt(const Solid& solid, Vec3 origin, Vec3 toward) {
  const Vec3 o = toLocal(solid.pose, origin), d = toLocal(solid.pose.rotation, toward);
  geom::RayHit hit{};
  const bool met = geom::visitShape(solid.kind, [&](auto shape) {
    return decltype(shape)::castRay(solid.shape, o, d, 2 * kRayStart, hit);
  });
  if (!met) return {};
  return hit.t;
}

// Returns the distance of each solid's nearest point along the viewing direction.
std::vector<float> nearestOf(const std::vector<Solid>& solids, Vec3 toward) {
  std::vector<float> out;
  for (const Solid& solid : solids) {
    out.push_back(geom::visitShape(solid.kind, [&](auto shape) {
      const Vec3 local = toLocal(solid.pose.rotation, -toward);
      return dot(toWorld(solid.pose, shape.corner(solid.shape, local)), toward);
    }));
  }
  return out;
}

// Places each solid after all those that it covers, otherwise by rank.
std::vector<size_t> placed(std::vector<std::vector<size_t>> coveredBy, std::vector<size_t> waiting,
                           const std::vector<size_t>& byRank) {
  std::vector<size_t> rank(waiting.size());
  for (size_t i = 0; i < byRank.size(); ++i) rank[byRank[i]] = i;
  std::set<std::pair<size_t, size_t>>
      left;  // solids covered by what they cover come when they must
  for (const size_t solid : byRank) left.insert({waiting[solid], rank[solid]});
  std::vector<size_t> out;
  while (!left.empty()) {
    const size_t solid = byRank[left.begin()->second];
    left.erase(left.begin());
    out.push_back(solid);
    for (const size_t other : coveredBy[solid]) {
      const auto node = left.extract({waiting[other], rank[other]});
      if (node.empty()) continue;
      left.insert({--waiting[other], rank[other]});
    }
  }
  return out;
}

}  // namespace

std::vector<size_t> depthOrder(const std::vector<Solid>& solids,
                               const std::vector<std::vector<Vec2>>& outlines, const Paper& paper) {
  const Vec3 toward = paper.toward();
  const std::vector<float> nearest = nearestOf(solids, toward);
  std::vector<size_t> byRank;
  std::vector<Bounds> bounds;
  for (size_t i = 0; i < solids.size(); ++i) {
    bounds.push_back(boundsOf(outlines[i]));
    if (!outlines[i].empty()) byRank.push_back(i);
  }
  std::stable_sort(byRank.begin(), byRank.end(),
                   [&](size_t a, size_t b) { return nearest[a] > nearest[b]; });
  std::vector<std::vector<size_t>> coveredBy(solids.size());
  std::vector<size_t> waiting(solids.size());
  for (size_t i = 0; i < byRank.size(); ++i) {
    for (size_t k = i + 1; k < byRank.size(); ++k) {
      const size_t a = byRank[i], b = byRank[k];
      if (!overlap(bounds[a], bounds[b])) continue;
      const std::optional<Vec2> shared = sharedPoint(outlines[a], outlines[b]);
      if (!shared) continue;
      const Vec3 origin = paper.at(*shared) - toward * kRayStart;
      const auto depthA = depthAt(solids[a], origin, toward);
      const auto depthB = depthAt(solids[b], origin, toward);
      if (!depthA || !depthB || std::abs(*depthA - *depthB) < kSameDepth) continue;
      const auto [back, front] = *depthA > *depthB ? std::pair(a, b) : std::pair(b, a);
      coveredBy[back].push_back(front);
      ++waiting[front];
    }
  }
  return placed(std::move(coveredBy), std::move(waiting), byRank);
}

}  // namespace obby::view
