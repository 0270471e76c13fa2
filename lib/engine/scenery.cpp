#include "engine/scenery.h"

#include <algorithm>

#include "geom/penetration.h"
#include "geom/shapes/table.h"

namespace obby::engine {
namespace {

constexpr float kTouchSkin = 0.05f;  // studs; the engine reports contacts at gaps up to this size

bool overlap(const Scenery::Part& part, const Pose& frame, Vec3 half) {
  const geom::LocalBox box{
      toLocal(part.pose, frame.position),
      {toLocal(part.pose.rotation, frame.rotation.x), toLocal(part.pose.rotation, frame.rotation.y),
       toLocal(part.pose.rotation, frame.rotation.z)},
      half};
  return geom::penetration(part.shape, {part.half}, box).depth >= 0;
}

// Forwards to overlaps() of boxes, which Scenery::overlaps hides.
bool boxesMeet(const Box& a, const Box& b) { return overlaps(a, b); }

}  // namespace

void Scenery::add(uint32_t id, const Part& part) {
  parts_[id] = part;
  moved(id);
}

void Scenery::remove(uint32_t id) {
  parts_.erase(id);
  if (listened_.erase(id) > 0) moved_.insert(id);
}

Scenery::Part* Scenery::find(uint32_t id) {
  const auto found = parts_.find(id);
  return found == parts_.end() ? nullptr : &found->second;
}

void Scenery::moved(uint32_t id) {
  const Part* const part = find(id);
  if (part && part->listened && !part->limb) listened_.insert(id);
  if (part && (part->listened || part->limb)) moved_.insert(id);
}

std::vector<uint32_t> Scenery::sorted(const Box& bounds) const {
  std::vector<uint32_t> ids;
  for (const auto& [id, part] : parts_)
    if (boxesMeet(boundsOf(part.pose, part.half), bounds)) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<uint32_t> Scenery::overlaps(const Pose& frame, Vec3 half) const {
  std::vector<uint32_t> ids = sorted(boundsOf(frame, half));
  std::erase_if(ids, [&](uint32_t id) { return !overlap(parts_.at(id), frame, half); });
  return ids;
}

std::vector<uint32_t> Scenery::overlapsOfPart(uint32_t id) const {
  const auto found = parts_.find(id);
  if (found == parts_.end()) return {};
  std::vector<uint32_t> ids = overlaps(found->second.pose, found->second.half);
  std::erase(ids, id);
  return ids;
}

std::vector<Scenery::RayHit> Scenery::castRay(Vec3 origin, Vec3 direction) const {
  const Box bounds = {min(origin, origin + direction), max(origin, origin + direction)};
  std::vector<RayHit> hits;
  for (const uint32_t id : sorted(bounds)) {
    const Part& part = parts_.at(id);
    const Vec3 from = toLocal(part.pose, origin), along = toLocal(part.pose.rotation, direction);
    geom::RayHit hit{};
    // Limbs meet in the middle of the body, where scripts often cast rays straight down. The gap
    // lets these pass.
    constexpr Vec3 kGap = {0.01f, 0.01f, 0.01f};
    const geom::ShapeData shape{part.limb ? part.half - kGap : part.half};
    const bool met =
        visitShape(part.shape, [&](auto s) { return s.castRay(shape, from, along, 1.0f, hit); });
    if (met) hits.push_back({id, hit.t, part.pose.rotation * hit.normal});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const RayHit& a, const RayHit& b) { return a.share < b.share; });
  return hits;
}

float Scenery::distance(uint32_t id, Vec3 point) const {
  const Part& part = parts_.at(id);
  const Vec3 local = toLocal(part.pose, point);
  return length(local - max(min(local, part.half), -part.half));
}

bool Scenery::contacts(uint32_t limb, std::vector<uint32_t>& out) {
  const Part* const own = find(limb);
  if (!own || moved_.empty()) return false;
  const Vec3 half = own->half + Vec3{kTouchSkin, kTouchSkin, kTouchSkin};
  if (own->listened) {
    out = overlaps(own->pose, half);
    return true;
  }
  const Box bounds = boundsOf(own->pose, half);
  for (const uint32_t id : listened_) {
    const Part& part = parts_.at(id);
    if (boxesMeet(boundsOf(part.pose, part.half), bounds) && overlap(part, own->pose, half))
      out.push_back(id);
  }
  return true;
}

}  // namespace obby::engine
