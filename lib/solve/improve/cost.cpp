#include "solve/improve/cost.h"

#include <algorithm>
#include <cmath>

#include "geom/region.h"
#include "sim/carrier.h"
#include "sim/targets.h"
#include "solve/model/trajectory.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

constexpr float kHazardReach = 3;      // studs at which a part that kills begins to cost
constexpr float kEdgeReach = 1;        // studs from an edge at which it begins to cost
constexpr float kLandingReach = 1.5f;  // studs, for landings
constexpr float kMinSpeed = 2;         // studs/s; a slower player has no direction of movement

// Returns 1 at distance 0 or less, 0 from `reach` on.
float closeness(float distance, float reach) {
  const float share = std::clamp(1 - distance / reach, 0.0f, 1.0f);
  return share * share;
}

bool changesKeys(const sim::Action& from, const sim::Action& to) {
  if (to.jump && !from.jump) return true;
  return from.walk != to.walk || (to.walk && from.heading != to.heading);
}

}  // namespace

CostMeter::CostMeter(const Problem& problem, const CostWeights& weights, const Box& space)
    : problem_(problem),
      weights_(weights),
      secondsPerTick_(1.0 / problem.level.params.controlRate) {
  const Vec3 reach{kHazardReach, kHazardReach, kHazardReach};
  const Box near{space.lo - reach, space.hi + reach};
  for (uint32_t i = 0; i < problem.level.colliderCount; ++i) {
    const level::Bounds& bounds = problem.level.bounds[i];
    if (!(bounds.flags & level::kKill)) continue;
    if ((bounds.flags & level::kDynamic) || overlaps(bounds.box(), near)) hazards_.push_back(i);
  }
}

void CostMeter::note(CostState& state, const sim::Action& action, bool jumped,
                     const sim::World& after, const sim::RigidBody* bodies) const {
  state.cost += weights_.second * secondsPerTick_;
  if (jumped) state.cost += weights_.jump;
  if (changesKeys(state.last, action)) state.cost += weights_.change;
  state.last = action;
  const bool inAir = !grounded(after);
  if (state.inAir && !inAir && weights_.landing > 0)
    state.cost += double(weights_.landing * nearEdge(after, bodies, kLandingReach));
  state.inAir = inAir;
  if (++state.ticks % kPathStep == 0) state.cost += sampled(state, after, bodies);
}

double CostMeter::sampled(CostState& state, const sim::World& w,
                          const sim::RigidBody* bodies) const {
  double cost = 0;
  const float vx = w.velocity.x, vz = w.velocity.z;
  if (vx * vx + vz * vz > kMinSpeed * kMinSpeed) {
    const Turns heading = headingOf(vx, vz);
    const int turned = state.moved ? std::abs(int(int16_t(Turns(heading - state.heading)))) : 0;
    cost += double(weights_.turn) * turned * double(kRadiansPerTurn);
    state.heading = heading;
    state.moved = true;
  }
  const double seconds = kPathStep * secondsPerTick_;
  if (weights_.hazard > 0 && !hazards_.empty())
    cost += double(weights_.hazard * nearHazard(w, bodies)) * seconds;
  if (weights_.edge > 0) cost += double(weights_.edge * nearEdge(w, bodies, kEdgeReach)) * seconds;
  return cost;
}

float CostMeter::nearHazard(const sim::World& w, const sim::RigidBody* bodies) const {
  const level::LevelView& level = problem_.level;
  const float top = level.params.bodyTop;
  float worst = 0;
  for (const uint32_t i : hazards_) {
    const level::Collider& c = level.colliders[i];
    if (sim::isGone(c, bodies)) continue;
    const geom::Region space{sim::poseAfter(level, w, bodies, c), c.shape.half};
    for (const float height : {0.0f, 0.5f * top, top}) {
      const float distance = geom::distance(space, w.position + Vec3{0, height, 0});
      worst = std::max(worst, closeness(distance - 0.5f * level.params.bodyWidth, kHazardReach));
    }
  }
  return worst;
}

float CostMeter::nearEdge(const sim::World& w, const sim::RigidBody* bodies, float reach) const {
  if (w.state != sim::State::running && w.state != sim::State::landed) return 0;
  const uint32_t collider = sim::carrierOf(w, bodies, problem_.level);
  if (collider == level::kNone) return 0;
  const level::Collider& c = problem_.level.colliders[collider];
  const Vec3 local = toLocal(sim::poseAfter(problem_.level, w, bodies, c), w.position);
  const Vec3 half = c.shape.half;
  const float inside = std::min(half.x - std::abs(local.x), half.z - std::abs(local.z));
  // A player on a narrow beam has no choice.
  return closeness(inside, std::min(reach, std::min(half.x, half.z)));
}

}  // namespace obby::solve
