#include "solve/build_query.h"

#include <fmt/format.h>

#include "solve/select_parts.h"

namespace obby::solve {

namespace {

void fillRegion(schema::Region::Builder record, const PlainRegion& region) {
  record.setName(region.name);
  auto p = record.initPosition();
  p.setX(region.position.x);
  p.setY(region.position.y);
  p.setZ(region.position.z);
  auto q = record.initRotation();
  q.setX(region.rotation.x);
  q.setY(region.rotation.y);
  q.setZ(region.rotation.z);
  q.setW(region.rotation.w);
  auto s = record.initSize();
  s.setX(region.size.x);
  s.setY(region.size.y);
  s.setZ(region.size.z);
}

// The option that a bad selector belongs to.
Error inOption(Error error, const char* option) {
  error.path = option;
  return error;
}

Result<std::vector<PlainRegion>> regionsFor(schema::Level::Reader level,
                                            const std::string& selector, const char* option,
                                            bool several) {
  auto box = boxFromText(selector);
  if (!box) return inOption(box.error(), option);
  if (*box) return std::vector<PlainRegion>{**box};
  std::vector<uint32_t> parts;
  if (several) {
    auto found = matchParts(level, selector);
    if (!found) return inOption(found.error(), option);
    parts = *std::move(found);
  } else {
    auto found = matchPart(level, selector);
    if (!found) return inOption(found.error(), option);
    parts.push_back(*found);
  }
  std::vector<PlainRegion> regions;
  for (const uint32_t part : parts) regions.push_back(regionAround(level.getParts()[part]));
  return regions;
}

Status fillStart(schema::Level::Reader level, const std::string& selector,
                 schema::Query::Builder query) {
  if (selector.empty()) {
    if (level.getSpawns().size() > 0) return {};
    return inOption(makeError(fmt::format("level '{}' has no spawn", level.getName().cStr()),
                              "name a part or a box to start from"),
                    "--start");
  }
  auto start = query.initStart();
  auto box = boxFromText(selector);
  if (!box) return inOption(box.error(), "--start");
  if (*box) {
    fillRegion(start.initRegion(), **box);
    return {};
  }
  const auto part = matchPart(level, selector);
  if (!part) return inOption(part.error(), "--start");
  for (uint32_t i = 0; i < level.getSpawns().size(); ++i) {
    if (level.getSpawns()[i].getPart() == int32_t(*part)) {
      start.setSpawn(int32_t(i));
      return {};
    }
  }
  fillRegion(start.initRegion(), regionOnTop(level.getParts()[*part]));
  return {};
}

// The part where the level ends: a goal of stage 0, any goal, or the last checkpoint; -1: none.
int64_t lastPart(schema::Level::Reader level) {
  int64_t goal = -1, checkpoint = -1;
  bool final = false;
  int32_t stage = 0;
  uint32_t i = 0;
  for (const auto part : level.getParts()) {
    if (part.hasGoal() && (goal < 0 || (!final && part.getGoal().getStage() == 0))) {
      goal = i;
      final = part.getGoal().getStage() == 0;
    }
    if (part.hasCheckpoint() && part.getCheckpoint().getStage() > stage) {
      checkpoint = i;
      stage = part.getCheckpoint().getStage();
    }
    ++i;
  }
  return goal >= 0 ? goal : checkpoint;
}

Status fillGoal(schema::Level::Reader level, const std::string& selector,
                schema::Query::Builder query) {
  if (!selector.empty()) {
    OBBY_ASSIGN(const auto regions, regionsFor(level, selector, "--goal", false));
    fillRegion(query.initGoal(), regions.front());
    return {};
  }
  const int64_t part = lastPart(level);
  if (part < 0) {
    return inOption(makeError(fmt::format("level '{}' has no query, no goal part and no checkpoint",
                                          level.getName().cStr()),
                              "name a part or a box to reach, or write a query record"),
                    "--goal");
  }
  fillRegion(query.initGoal(), regionAround(level.getParts()[uint32_t(part)]));
  return {};
}

Status fillAvoid(schema::Level::Reader level, const std::vector<std::string>& selectors,
                 schema::Query::Builder query) {
  std::vector<PlainRegion> all;
  for (const std::string& selector : selectors) {
    OBBY_ASSIGN(const auto regions,
                regionsFor(level, selector, "--avoid", selector.starts_with("#")));
    all.insert(all.end(), regions.begin(), regions.end());
  }
  if (all.empty()) return {};
  auto avoid = query.initAvoid(uint32_t(all.size()));
  for (uint32_t i = 0; i < avoid.size(); ++i) fillRegion(avoid[i], all[i]);
  return {};
}

}  // namespace

Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id) {
  io::RecordBuilder record;
  auto query = record.root().initQuery();
  query.setId(id);
  query.setLevel(level.getName());
  OBBY_RETURN_IF_ERROR(fillStart(level, quick.start, query));
  OBBY_RETURN_IF_ERROR(fillGoal(level, quick.goal, query));
  if (!quick.waypoints.empty()) {
    auto waypoints = query.initWaypoints(uint32_t(quick.waypoints.size()));
    for (uint32_t i = 0; i < waypoints.size(); ++i) {
      OBBY_ASSIGN(const auto regions, regionsFor(level, quick.waypoints[i], "--waypoint", false));
      fillRegion(waypoints[i].initRegion(), regions.front());
    }
  }
  OBBY_RETURN_IF_ERROR(fillAvoid(level, quick.avoid, query));
  query.setMaxJumps(quick.maxJumps);
  query.setTimeLimit(quick.timeLimit);
  return io::Record(std::move(record));
}

}  // namespace obby::solve
