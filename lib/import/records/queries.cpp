// Writes one query for each stage, with the checkpoint's or goal's part as goal region.
#include "import/records/queries.h"

#include <algorithm>
#include <cmath>

#include "engine/observation.h"
#include "import/records/level_record.h"
#include "import/records/place_names.h"
#include "import/records/record_values.h"

namespace obby::importer {
namespace {

constexpr float kAbove = 0.5f;    // studs above the part
constexpr float kSideMargin = 1;  // studs on each side
constexpr float kMin = 0.05f;     // studs; the simulator makes thinner parts this thick

struct Target {
  int part;
  int from;  // index into spawns
};

std::vector<Target> targets(const LevelDraft& level) {
  std::vector<Target> list;
  for (int i = 1; i < int(level.spawns.size()); ++i)
    list.push_back({level.spawns[size_t(i)].part, i - 1});
  const int last = int(level.spawns.size()) - 1;
  for (int i = 0; i < int(level.parts.size()); ++i) {
    const PartDraft& part = level.parts[size_t(i)];
    const bool isLast = level.spawns[size_t(last)].part == i;
    if (part.goal && !part.checkpoint && !isLast) list.push_back({i, last});
  }
  return list;
}

// Returns the level's clock after all single events. Players past the first stage have been in the
// level for a while.
uint32_t laterTick(const LevelDraft& level) {
  double last = 0;
  for (const PartDraft& part : level.parts) {
    if (part.vanish && part.vanish->timer && part.vanish->away >= kGone)
      last = std::max(last, double(part.vanish->delay));
    if (part.motion && part.motion->trigger == MotionTrigger::always &&
        part.motion->repeat == Repeat::once && !part.motion->keys.empty())
      last = std::max(last, double(part.motion->keys.back().time - part.motion->offset));
  }
  return uint32_t(std::ceil(last / engine::kFrame));
}

}  // namespace

GoalBox goalBox(const PartDraft& part) {
  const Mat3& r = part.pose.rotation;
  const float up[3] = {absf(r.x.y), absf(r.y.y), absf(r.z.y)};
  const int tall = up[0] > up[1] ? (up[0] > up[2] ? 0 : 2) : (up[1] >= up[2] ? 1 : 2);
  const Vec3 axis = tall == 0 ? r.x : tall == 1 ? r.y : r.z;
  float size[3] = {maxf(part.size.x, kMin), maxf(part.size.y, kMin), maxf(part.size.z, kMin)};
  for (int i = 0; i < 3; ++i) size[i] += i == tall ? kAbove : 2 * kSideMargin;
  GoalBox box{part.pose, {size[0], size[1], size[2]}};
  box.pose.position += axis * ((axis.y < 0 ? -0.5f : 0.5f) * kAbove);
  return box;
}

std::vector<io::RecordBuilder> stageQueries(const LevelDraft& level, const Tree& tree) {
  std::vector<io::RecordBuilder> queries;
  if (level.spawns.empty()) return queries;
  int number = 0;
  const PlaceNames names(level, tree);
  for (const Target& target : targets(level)) {
    const PartDraft& part = level.parts[size_t(target.part)];
    io::RecordBuilder record;
    auto query = record.root().initQuery();
    query.setId("stage" + std::to_string(++number));
    query.setTitle(validUtf8("Stage " + std::to_string(number) + ": " +
                             names.of(level.spawns[size_t(target.from)].part) + " to " +
                             names.of(target.part)));
    query.setLevel(validUtf8(level.name));
    auto start = query.initStart();
    start.setSpawn(target.from);
    if (target.from > 0) start.setTick(laterTick(level));
    const GoalBox box = goalBox(part);
    auto goal = query.initGoal();
    goal.setName(validUtf8(tree.at(part.id).name));
    goal.setPartIndex(target.part);
    setVector(goal.initPosition(), box.pose.position);
    setRotation(goal.initRotation(), box.pose.rotation);
    setVector(goal.initSize(), box.size);
    queries.push_back(std::move(record));
  }
  return queries;
}

}  // namespace obby::importer
