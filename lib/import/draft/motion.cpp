// Turns sampled poses into keys, and spreads a motion over the parts that move together.
#include "import/draft/motion.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "engine/classes/class_defaults.h"
#include "engine/observation.h"
#include "import/document/pivot.h"
#include "import/document/pose_math.h"
#include "import/draft/motion_budget.h"
#include "level/motion_tables.h"

namespace obby::importer {
namespace {

constexpr float kStill = 0.01f;      // studs; smaller moves count as rest
constexpr float kUnturned = 0.005f;  // radians; smaller turns count as rest
constexpr double kJumpGap = 0.15;    // max seconds between samples of a smooth motion
constexpr float kStraight = 0.02f;   // max studs between an omitted key and the straight line
constexpr float kStraightTurn = 0.01f;

MotionKey keyAt(double time, const Pose& pose) {
  return {float(time), pose, Easing::linear, EasingDirection::out};
}

// Max deviation of omitted keys from the straight line.
struct Straight {
  float place = kStraight, turn = kStraightTurn;
};

bool isStraight(const std::vector<MotionKey>& keys, size_t from, size_t to, Straight slack) {
  for (size_t i = from + 1; i < to; ++i) {
    const float span = keys[to].time - keys[from].time;
    const float t = span > 0 ? (keys[i].time - keys[from].time) / span : 0;
    const Pose expected = between(keys[from].pose, keys[to].pose, t);
    if (length(expected.position - keys[i].pose.position) > slack.place ||
        length(rotationVector(expected.rotation * inverse(keys[i].pose.rotation))) > slack.turn)
      return false;
  }
  return true;
}

std::vector<MotionKey> simplified(const std::vector<MotionKey>& keys, Straight slack) {
  constexpr size_t kLongest = 64;  // max keys replaced by one straight line; bounds the work
  std::vector<MotionKey> out;
  for (size_t from = 0; from < keys.size();) {
    out.push_back(keys[from]);
    size_t to = from + 1;
    while (to + 1 < keys.size() && to - from < kLongest && isStraight(keys, from, to + 1, slack))
      ++to;
    from = to;
  }
  return out;
}

// Simplifies twice, so that a long straight line keeps only its two end keys. The second pass has a
// tighter tolerance.
std::vector<MotionKey> simplified(const std::vector<MotionKey>& keys) {
  constexpr float kClose = 0.1f;
  return simplified(simplified(keys, {}), {kClose * kStraight, kClose * kStraightTurn});
}

// Returns the parts that move when `moved` does.
std::vector<InstanceId> followers(RoleContext& context, InstanceId moved) {
  std::vector<InstanceId> all = context.tree.partsOf(moved);
  const size_t own = all.size();
  std::unordered_set<InstanceId> hung;  // visits each assembly once, however many parts it has
  for (size_t i = 0; i < own; ++i) {
    if (hung.count(all[i]) > 0) continue;
    const auto members = context.assemblies.members(all[i]);
    if (members.size() > 1) hung.insert(members.begin(), members.end());
    for (InstanceId member : members)
      if (!get<bool>(context.tree.at(member), "Anchored")) all.push_back(member);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

bool samePose(const Pose& a, const Pose& b) {
  return length(a.position - b.position) < kStill &&
         length(rotationVector(a.rotation * inverse(b.rotation))) < kUnturned;
}

std::vector<MotionKey> keysThrough(const Pose& start, const std::vector<PoseSample>& samples) {
  std::vector<MotionKey> keys = {keyAt(0, start)};
  for (const PoseSample& sample : samples) keys.push_back(keyAt(sample.time, sample.pose));
  return simplified(keys);
}

std::vector<MotionKey> keysFrom(const Pose& start, const std::vector<PoseSample>& samples,
                                double period, bool closed) {
  std::vector<MotionKey> keys = {keyAt(0, start)};
  for (const auto& sample : samples) {
    const double gap = sample.time - double(keys.back().time);
    if (gap > kJumpGap) keys.push_back(keyAt(sample.time - engine::kFrame, keys.back().pose));
    keys.push_back(keyAt(std::max(sample.time, double(keys.back().time)), sample.pose));
  }
  if (period > double(keys.back().time)) {
    const bool pauses = period - double(keys.back().time) > kJumpGap;
    keys.push_back(keyAt(period, closed && !pauses ? start : keys.back().pose));
  }
  return simplified(keys);
}

namespace {

static_assert(kLongestMotion * 60 == float(level::kMaxRows));

// Returns true if the simulator accepts the motion: bounded rounds, turns and waits, and positions
// within the world.
bool isBounded(const Motion& motion) {
  constexpr float kFarthest = 1e6f;
  float before = 0;
  for (const MotionKey& key : motion.keys) {
    const Mat3& turned = key.pose.rotation;
    if (!isFinite(key.pose.position) || length(key.pose.position) > kFarthest) return false;
    if (!isFinite(turned.x) || !isFinite(turned.y) || !isFinite(turned.z)) return false;
    if (!(key.time >= before)) return false;
    before = key.time;
  }
  const float rounds = motion.repeat == Repeat::pingPong ? 2 : 1;
  if (!motion.keys.empty() && motion.keys.back().time * rounds > kLongestMotion) return false;
  if (!std::isfinite(motion.offset) || motion.offset < -kLongestMotion) return false;
  if (!motion.spin) return true;
  if (!isFinite(motion.spin->axis) || length(motion.spin->axis) < 1e-6f) return false;
  const float speed = absf(motion.spin->speed);
  return std::isfinite(speed) && speed * kLongestMotion > 2 * 3.1416f &&
         length(motion.spin->pivot) <= kFarthest;  // rejects NaN, too
}

// Returns how many straight pieces approximate the arc of a part `reach` studs from the pivot.
int piecesOf(const MotionKey& from, const MotionKey& to, float reach) {
  constexpr double kTicks = 60, kMax = 600;
  const float turn = length(rotationVector(to.pose.rotation * inverse(from.pose.rotation)));
  if (!(reach * (1 - std::cos(turn / 2)) > kStraight)) return 1;
  const double ticks = std::ceil(double(to.time - from.time) * kTicks);
  double pieces = std::ceil(double(turn) / (2 * std::acos(1 - double(kStraight) / double(reach))));
  if (to.easing != Easing::linear) pieces = std::max(pieces, ticks / 2);
  return int(std::max(1.0, std::min({pieces, ticks, kMax})));
}

}  // namespace

Motion withArcs(const Motion& motion, float reach) {
  constexpr size_t kMaxKeys = 3000;
  Motion out = motion;
  out.keys.clear();
  for (const MotionKey& key : motion.keys) {
    const bool first = out.keys.empty() || out.keys.size() > kMaxKeys;
    const int pieces = first ? 1 : piecesOf(out.keys.back(), key, reach);
    const MotionKey from = first ? key : out.keys.back();
    for (int i = 1; i < pieces; ++i) {
      const double share = double(i) / pieces;
      const auto eased = float(
          level::ease(schema::Easing(key.easing), schema::EasingDirection(key.direction), share));
      out.keys.push_back(keyAt(double(from.time) + double(key.time - from.time) * share,
                               between(from.pose, key.pose, eased)));
    }
    out.keys.push_back(pieces > 1 ? keyAt(double(key.time), key.pose) : key);
  }
  return out;
}

namespace {

// Returns the parts of the level that get a motion of `moved`.
std::vector<PartDraft*> takers(RoleContext& context, InstanceId moved) {
  std::vector<PartDraft*> parts;
  for (InstanceId id : followers(context, moved))
    if (PartDraft* part = context.part(id); part && !part->motion) parts.push_back(part);
  return parts;
}

}  // namespace

int giveMotion(RoleContext& context, InstanceId moved, const Motion& ofPivot,
               const std::string& reason, bool guessed) {
  const Pose pivot = pivotOf(context.tree, moved);
  const std::vector<PartDraft*> parts = takers(context, moved);
  float reach = 0;
  for (const PartDraft* part : parts)
    reach = std::max(reach, length(toLocal(pivot, part->pose.position)));
  const Motion motion = withArcs(ofPivot, reach);
  if (!fitsBudget(context, parts, motion, reason)) return 0;
  int given = 0;
  for (PartDraft* part : parts) {
    if (!partFitsBudget(context, *part, motion, reason)) continue;
    const Pose inPivot = inverse(pivot) * part->pose;
    Motion own = motion;
    for (MotionKey& key : own.keys) key.pose = key.pose * inPivot;
    if (own.spin) {
      own.spin->axis = toLocal(inPivot.rotation, own.spin->axis);
      own.spin->pivot = toLocal(inPivot, motion.spin->pivot);
    }
    if (!isBounded(own)) {
      context.level.noteUnmodelled(
          "motion out of range", context.tree, part->id,
          "it lasts or waits longer than 20 minutes, runs back in time, has no axis of rotation or "
          "leaves the world; the part stays at its position in the file; " +
              reason);
      continue;
    }
    spend(context, *part, own);
    part->motion = std::move(own);
    part->anchored = true;  // nothing pushes it off its trajectory
    part->evidence.push_back({"motion", reason, guessed});
    ++given;
  }
  return given;
}

}  // namespace obby::importer
