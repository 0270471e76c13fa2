#include "view/extent.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace obby::view {
namespace {

constexpr float kAround = 6;       // margin, studs
constexpr float kGround = 4;       // a ground is this much longer than all else
constexpr float kMinGround = 500;  // studs

template <class T>  // Part or Region
Corners cornersFrom(T reader) {
  const auto p = reader.getPosition();
  const auto q = reader.getRotation();
  const auto s = reader.getSize();
  const Mat3 axes = toMat3(normalize(Quat{q.getX(), q.getY(), q.getZ(), q.getW()}));
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 local{(i & 1 ? 0.5f : -0.5f) * s.getX(), (i & 2 ? 0.5f : -0.5f) * s.getY(),
                     (i & 4 ? 0.5f : -0.5f) * s.getZ()};
    corners[size_t(i)] = Vec3{p.getX(), p.getY(), p.getZ()} + axes * local;
  }
  return corners;
}

}  // namespace

Corners cornersOf(schema::Part::Reader part) { return cornersFrom(part); }
Corners cornersOf(schema::Region::Reader region) { return cornersFrom(region); }

Box boxOf(const Corners& corners) {
  Box box{corners[0], corners[0]};
  for (const Vec3 c : corners) box = join(box, {c, c});
  return box;
}

Box extentOf(const LevelEntry& level, const QueryEntry& query) {
  bool any = false;
  Box all{};
  const auto take = [&](const Box& box) {
    all = any ? join(all, box) : box;
    any = true;
  };
  if (query.query) {
    forRegions(query.reader(),
               [&](schema::Region::Reader region, RegionKind) { take(boxOf(cornersOf(region))); });
    if (query.compiled) take({query.compiled->start().feet, query.compiled->start().feet});
  }
  for (const PathEntry& path : query.paths) {
    // Attempts may fall far away, so only their starts and the solutions count.
    const size_t last = path.kind == PathKind::attempt ? 1 : path.playback.feet.size();
    for (size_t i = 0; i < last; ++i) take({path.playback.feet[i], path.playback.feet[i]});
  }
  if (!any) return level.level->bounds();
  return grow(all, {kAround, kAround, kAround});
}

Box courseOf(const LevelEntry& level) {
  std::vector<Box> boxes;
  for (const auto part : level.reader().getParts()) boxes.push_back(boxOf(cornersOf(part)));
  if (boxes.empty()) return level.level->bounds();
  const auto lengthOf = [](const Box& box) { return length(box.hi - box.lo); };
  std::sort(boxes.begin(), boxes.end(),
            [&](const Box& a, const Box& b) { return lengthOf(a) < lengthOf(b); });
  Box rest = boxes[0];
  for (const Box& box : boxes) {
    if (lengthOf(box) > std::max(kMinGround, kGround * lengthOf(rest))) break;
    rest = join(rest, box);
  }
  return rest;
}

Vec3 alongOf(const Box& extent, const QueryEntry* query) {
  const Vec3 size = extent.hi - extent.lo;
  const Vec3 along = size.x >= size.z ? Vec3{1, 0, 0} : Vec3{0, 0, -1};
  if (!query || !query->compiled) return along;
  const Vec3 goal = query->compiled->view().goal.region.pose.position;
  return dot(goal - query->compiled->start().feet, along) < 0 ? -along : along;
}

std::string lengthText(float studs) {
  return studs < 100 ? fmt::format("{:.3g}", studs) : fmt::format("{:.0f}", studs);
}

}  // namespace obby::view
