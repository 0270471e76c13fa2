#include "solve/search/selectors/rrt_selector.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr float kGoalShare = 0.05f;     // share of targets in the next region: OMPL's default bias
constexpr float kSurfaceShare = 0.7f;   // share of targets above a surface: space is mostly air
constexpr float kSpread = 2;            // studs, max horizontal offset from a surface point
constexpr uint32_t kClockTicks = 4096;  // ticks in which moving surfaces are sampled: over a minute
constexpr uint32_t kShortest = 6;  // min ticks of a rollout, so that a turn changes where it ends
constexpr uint32_t kTaskTargets = 16;  // targets per task of the pool

// Draws a point uniformly from a box.
Vec3 pointIn(const Box& box, Random& random) {
  const Vec3 size = box.hi - box.lo;
  const float x = random.unit(), y = random.unit(), z = random.unit();
  return box.lo + mul(size, {x, y, z});
}

}  // namespace

GoExploreSettings rrtSettings() {
  GoExploreSettings s;
  s.phaseJumps = 1;
  s.groundedOnly = false;  // states in the air are nodes, too
  s.explore.aimShare = 0;
  return s;
}

RrtSelector::RrtSelector(const Problem& problem, const ExploreContext& context)
    : level_(problem.level),
      query_(problem.query),
      surfaces_(context.surfaces),
      start_(problem.start),
      space_(problem.bounds),
      jumpHeight_(context.reach.height) {
  space_.hi.y += jumpHeight_;
}

// A cell is filed at the position where it was first reached; a replacement lies in the same cell.
void RrtSelector::addCells(const Archive& archive) {
  for (; known_ < archive.cellCount(); ++known_) {
    const sim::World& w = archive.world(known_);
    nearest_.add(targetsReached(w), w.position, known_);
  }
}

// Returns a next region for a player with this progress. Visits have no order, so one is drawn.
const geom::Region& RrtSelector::regionAfter(uint32_t layer, Random& random) const {
  if (layer >= targetCount(query_)) {
    const uint32_t i = random.below(1 + query_.otherGoalCount);
    return i == 0 ? query_.goal.region : query_.otherGoals[i - 1].region;
  }
  if (query_.visitCount == 0) return query_.waypoints[layer].target.region;
  const uint32_t i = random.below(targetCount(query_));
  return i < query_.visitCount ? query_.visits[i].region
                               : query_.waypoints[i - query_.visitCount].target.region;
}

Vec3 RrtSelector::nearSurface(Random& random) const {
  const SurfacePoint& point = surfaces_.points[random.below(surfaces_.pointCount)];
  sim::World then = start_;
  then.tick += random.below(kClockTicks);
  const Vec3 at = positionIn(level_, point, then);
  const float x = within(random, kSpread), z = within(random, kSpread);
  return at + Vec3{x, random.unit() * jumpHeight_, z};
}

RrtSelector::Target RrtSelector::draw(Random& random) const {
  uint32_t layer = random.below(nearest_.layers());
  while (nearest_.empty(layer)) ++layer;  // several targets may be reached in one tick
  const float kind = random.unit();
  if (kind < kGoalShare) return {layer, pointInRegion(regionAfter(layer, random), random)};
  const bool air = surfaces_.pointCount == 0 || kind >= kGoalShare + kSurfaceShare;
  return {layer, air ? pointIn(space_, random) : nearSurface(random)};
}

void RrtSelector::choose(const Archive& archive, ThreadPool& pool, Random& random,
                         std::span<Choice> choices) {
  addCells(archive);
  targets_.clear();
  for (Choice& c : choices) {
    targets_.push_back(draw(random));
    c.ticks = kShortest < c.ticks ? kShortest + random.below(c.ticks - kShortest + 1) : c.ticks;
  }
  pool.run(int((choices.size() + kTaskTargets - 1) / kTaskTargets), [&](int task) {
    const size_t last = std::min((size_t(task) + 1) * kTaskTargets, choices.size());
    for (size_t i = size_t(task) * kTaskTargets; i < last; ++i) {
      choices[i].cell = nearest_.nearest(targets_[i].layer, targets_[i].position);
    }
  });
}

std::unique_ptr<Selector> makeRrtSelector(const Problem& problem, const ExploreContext& context) {
  return std::make_unique<RrtSelector>(problem, context);
}

}  // namespace obby::solve
