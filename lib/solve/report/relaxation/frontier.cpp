#include "solve/report/relaxation/frontier.h"

#include <algorithm>

#include "solve/proof/boxes.h"
#include "solve/proof/supports.h"

namespace obby::solve {

namespace {

constexpr float kFarthest = 16;       // max studs sideways from a reached support
constexpr float kHighest = 24;        // max studs above a reached support
constexpr float kGoalWeight = 0.25f;  // weight of a stud to the target, per stud of gap or rise

class Frontier {
 public:
  explicit Frontier(const Failure& failure)
      : failure_(failure),
        problem_(problemOf(failure.posed)),
        motions_(partMotions(problem_.level)),
        limits_(problem_, motions_),
        supports_(supportsOf(problem_, limits_, motions_)) {
    markReached();
  }

  std::vector<uint32_t> parts(size_t count) {
    std::vector<uint32_t> result;
    const auto add = [&](uint32_t part) {
      const bool known = std::find(result.begin(), result.end(), part) != result.end();
      if (!known && result.size() < count && movable(part)) result.push_back(part);
    };
    const auto& cut = failure_.outcome.cut;
    if (cut && cut->missing.to != level::kNone) add(partOf(cut->missing.to));
    for (const uint32_t i : nearest()) add(partOf(supports_[i].collider));
    return result;
  }

 private:
  uint32_t partOf(uint32_t collider) const { return problem_.level.colliders[collider].part; }

  // Excludes kill parts, which have another relaxation, and dynamic parts, which would fall.
  bool movable(uint32_t part) const {
    const auto record = failure_.posed.levelRecord.getParts()[part];
    return !record.hasKill() && record.getAnchored();
  }

  void markReached() {
    reached_.assign(supports_.size(), false);
    reached_[0] = true;                                             // the start
    const std::vector<Vec3> places = failure_.footprints.places();  // in order of x
    for (size_t i = 1; i < supports_.size(); ++i) {
      reached_[i] = failure_.outcome.cut ? inCut(supports_[i]) : wasOn(supports_[i], places);
    }
  }

  bool inCut(const Support& s) const {
    if (s.collider == level::kNone) return false;
    const std::vector<uint32_t>& parts = failure_.outcome.cut->reached;
    return std::binary_search(parts.begin(), parts.end(), partOf(s.collider));
  }

  bool wasOn(const Support& s, const std::vector<Vec3>& places) const {
    if (!s.carries) return false;
    // `entry` is the min height of feet that the support begins to lift. Standing feet are
    // higher by the hip height.
    const float lowest = s.entry + problem_.level.params.hipHeight;
    const Box feet = grow(s.box, {s.side, s.lift, s.side});
    auto at = std::lower_bound(places.begin(), places.end(), feet.lo.x,
                               [](Vec3 p, float x) { return p.x < x; });
    for (; at != places.end() && at->x <= feet.hi.x; ++at) {
      const bool beside = at->z < feet.lo.z || at->z > feet.hi.z;
      if (!beside && at->y >= lowest && at->y <= feet.hi.y) return true;
    }
    return false;
  }

  // Returns the studs from the box's middle to the nearest place that the query names.
  float toTarget(const Box& box) const {
    const Vec3 middle = (box.lo + box.hi) * 0.5f;
    const level::QueryView& q = problem_.query;
    float min = geom::distance(q.goal.region, middle);
    const auto consider = [&](const level::TargetView& t) {
      min = std::min(min, geom::distance(t.region, middle));
    };
    for (uint32_t i = 0; i < q.otherGoalCount; ++i) consider(q.otherGoals[i]);
    for (uint32_t i = 0; i < q.waypointCount; ++i) consider(q.waypoints[i].target);
    for (uint32_t i = 0; i < q.visitCount; ++i) consider(q.visits[i]);
    return min;
  }

  // Returns the min sum of gap and rise from a reached support, in studs; 1e30 if it is out of
  // reach.
  float stepTo(const Support& to) const {
    float min = 1e30f;
    for (size_t i = 0; i < supports_.size(); ++i) {
      if (!reached_[i]) continue;
      const Support& from = supports_[i];
      const float gap = std::max(gapBetween(from.box, to.box) - from.side - to.side, 0.0f);
      const float rise = std::max(to.top() - from.top(), 0.0f);
      if (gap > kFarthest || rise > kHighest || to.leadsTo != level::kNone) continue;
      min = std::min(min, gap + rise);
    }
    return min;
  }

  // Returns the supports that were not reached, most promising first.
  std::vector<uint32_t> nearest() const {
    std::vector<std::pair<float, uint32_t>> ranked;
    for (uint32_t i = 1; i < supports_.size(); ++i) {
      const Support& s = supports_[i];
      if (reached_[i] || !s.carries || s.collider == level::kNone) continue;
      const float step = stepTo(s);
      if (step < 1e29f) ranked.emplace_back(step + kGoalWeight * toTarget(s.box), i);
    }
    std::sort(ranked.begin(), ranked.end());
    std::vector<uint32_t> result;
    result.reserve(ranked.size());
    for (const auto& [rank, i] : ranked) result.push_back(i);
    return result;
  }

  const Failure& failure_;
  const Problem problem_;
  const std::vector<PartMotion> motions_;
  const BodyLimits limits_;
  const std::vector<Support> supports_;
  std::vector<bool> reached_;  // (supports)
};

}  // namespace

std::vector<uint32_t> partsBeyond(const Failure& failure, size_t count) {
  return Frontier(failure).parts(count);
}

}  // namespace obby::solve
