#include "level/query_targets.h"

#include <fmt/format.h>

namespace obby::level {

Status checkLookedUp(schema::Region::Reader record, const std::string& path) {
  if (record.getPart().size() == 0 || record.getPartIndex() >= 0) return {};
  return pathError(path + ".part", "the query names a part, but lacks its position and size",
                   "run the query through obby-solve, which adds them");
}

Result<TargetView> QueryTargets::compile(schema::Region::Reader record, const std::string& path,
                                         schema::Arrive arrive) {
  OBBY_ASSIGN(TargetView target, boxOrPart(record, path));
  const int32_t part = record.getPartIndex();
  target.stand =
      arrive == schema::Arrive::STAND && !record.getTouch() && part >= 0 && isSolid(uint32_t(part));
  if (target.stand) leaveFoot(uint32_t(part), target.region);
  return target;
}

Result<std::vector<TargetView>> QueryTargets::compile(capnp::List<schema::Region>::Reader list,
                                                      const char* name, schema::Arrive arrive) {
  std::vector<TargetView> targets;
  for (const auto record : list) {
    OBBY_ASSIGN(const TargetView target,
                compile(record, fmt::format("{}[{}]", name, targets.size()), arrive));
    targets.push_back(target);
  }
  return targets;
}

Result<TargetView> QueryTargets::boxOrPart(schema::Region::Reader record, const std::string& path) {
  TargetView target;
  const int32_t part = record.getPartIndex();
  OBBY_RETURN_IF_ERROR(checkLookedUp(record, path));
  OBBY_ASSIGN(target.region, region(record, path));
  if (!record.getTouch()) return target;
  if (part < 0) {
    return pathError(path + ".touch", "this is a box, but only a part can be touched",
                     "name the part: {\"part\":\"Finish\",\"touch\":true}");
  }
  if (size_t(part) >= parts_) {
    return pathError(path + ".partIndex",
                     fmt::format("there is no part {}: the level has {} parts", part, parts_));
  }
  listTouched(uint32_t(part), target);
  if (target.touchCount == 0) {
    // The path may be that of an entry that came from a name or a tag, so the message names the
    // part.
    const std::string name = record.getPart().size() > 0 ? std::string(record.getPart().cStr())
                                                         : fmt::format("part:{}", part);
    return pathError(
        path + ".touch",
        fmt::format("'{}' cannot be touched: it is not solid and does nothing on touch", name),
        "remove 'touch' to ask for the box around the part");
  }
  return target;
}

bool QueryTargets::isSolid(uint32_t part) {
  const ColliderRun run = runs_.of(part);
  for (uint32_t i = run.first; i < run.first + run.count; ++i) {
    if (!(level_.bounds[i].flags & kSolid)) return false;
  }
  return run.count > 0;
}

// Removes the lower part of the region around a part with a level top: a player next to the part is
// not on it.
void QueryTargets::leaveFoot(uint32_t part, geom::Region& region) {
  const ColliderRun run = runs_.of(part);
  const Bounds& bounds = level_.bounds[run.first];
  const bool flat = run.count == 1 && (bounds.flags & kUpright) && !(bounds.flags & kHeldElsewhere);
  if (!flat || absf(region.pose.rotation.y.y) < 0.999f) return;
  const float high = region.pose.position.y + region.half.y;
  const float low = maxf(high - 2 * region.half.y, bounds.box().hi.y - kStandDepth);
  region.pose.position.y = 0.5f * (low + high);
  region.half.y = 0.5f * (high - low);
}

// Adds a part's colliders to touched_, once for each part. Lists may name a part again, and a tag
// may fit thousands of parts.
void QueryTargets::listTouched(uint32_t part, TargetView& target) {
  const ColliderRun run = runs_.of(part);
  listed_.resize(parts_, kNone);
  if (listed_[part] == kNone) {
    listed_[part] = uint32_t(touched_.size());
    for (uint32_t i = 0; i < run.count; ++i) touched_.push_back(run.first + i);
  }
  target.firstTouch = listed_[part];
  target.touchCount = run.count;
}

}  // namespace obby::level
