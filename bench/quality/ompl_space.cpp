#include "quality/ompl_space.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "math/bits.h"
#include "sim/next_region.h"
#include "solve/model/targets.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::bench {

namespace {

namespace ob = ompl::base;
namespace oc = ompl::control;

// Studs between two states for each target that only one has reached, or if only one has ended. No
// level is that large, so the nearest state has the same progress if any has.
constexpr double kTargetStuds = 1e5;
constexpr size_t kBodiesKept = 64;
constexpr uint64_t kBodiesEvery = 512;  // ticks
constexpr float kHeadroom = 8;          // studs above the level: a jump
constexpr uint32_t kTicksAhead = 60;    // of samples, beyond the latest state

double square(double x) { return x * x; }

double stepsBetween(const sim::World& a, const sim::World& b) {
  const bool onlyOne = (a.outcome == sim::Outcome::running) != (b.outcome == sim::Outcome::running);
  return std::abs(a.waypoints - b.waypoints) + int(bitCount(a.visited ^ b.visited)) + int(onlyOne);
}

class PlaySampler : public ob::StateSampler {
 public:
  explicit PlaySampler(const PlaySpace& space) : StateSampler(&space), play_(space) {}

  void sampleUniform(ob::State* state) override { play_.sample(playOf(state)); }
  void sampleUniformNear(ob::State* state, const ob::State* near, double) override {
    play_.copyState(state, near);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double) override {
    play_.copyState(state, mean);
  }

 private:
  const PlaySpace& play_;
};

class KeysSampler : public oc::ControlSampler {
 public:
  KeysSampler(const oc::ControlSpace& space, bool mayJump, uint64_t seed)
      : ControlSampler(&space), mayJump_(mayJump), random_(seed, 1) {}

  void sample(oc::Control* control) override {
    constexpr float kWalk = 0.9f, kJump = 0.5f;  // probabilities
    sim::Action& action = actionOf(control);
    action.walk = random_.unit() < kWalk;
    action.heading = action.walk ? Turns(random_.next()) : Turns(0);
    action.jump = random_.unit() < kJump && mayJump_;
  }

 private:
  const bool mayJump_;
  Random random_;
};

}  // namespace

Seen::Seen(const solve::Problem& problem)
    : firstTick(problem.start.tick),
      lastTick(problem.start.tick),
      progress{{problem.start.waypoints, problem.start.visited}},
      bodies{problem.startBodies} {}

void Seen::note(const sim::World& world, const std::vector<sim::RigidBody>& now) {
  if (++ticks % kBodiesEvery == 0 && !now.empty()) {
    if (bodies.size() < kBodiesKept) {
      bodies.push_back(now);
    } else {
      bodies[ticks / kBodiesEvery % kBodiesKept] = now;
    }
  }
  lastTick = std::max(lastTick, world.tick);
  jumps = std::max(jumps, world.jumps);
  const Progress reached{world.waypoints, world.visited};
  if (std::ranges::find(progress, reached) != progress.end()) return;
  progress.push_back(reached);
  std::ranges::stable_sort(progress, {},
                           [](const Progress& p) { return p.waypoints + bitCount(p.visited); });
}

PlaySpace::PlaySpace(const solve::Problem& problem, const Seen& seen, uint64_t seed)
    : problem_(problem),
      seen_(seen),
      scales_{0.1, problem.hasClock ? 0.05 : 0,
              solve::limitsJumps(problem.query) || problem.query.minJumps > 0 ? 2.0 : 0,
              10 / double(problem.level.params.maxHealth), problem.startBodies.empty() ? 0.0 : 0.5},
      random_(seed, 0) {
  for (uint32_t i = 0; i < problem.level.colliderCount; ++i) {
    const level::Bounds& bounds = problem.level.bounds[i];
    if (bounds.flags & level::kSolid) floors_.push_back(bounds.box());
  }
}

double PlaySpace::getMaximumExtent() const {
  return double(length(problem_.bounds.hi - problem_.bounds.lo)) + 1;
}

double PlaySpace::distance(const ob::State* a, const ob::State* b) const {
  const sim::World &x = playOf(a).world, &y = playOf(b).world;
  const Vec3 step = x.position - y.position, change = x.velocity - y.velocity;
  double sum = double(dot(step, step)) + square(scales_.velocity) * double(dot(change, change));
  sum += square(scales_.tick * (double(x.tick) - double(y.tick)));
  sum += square(scales_.jump * (x.jumps - y.jumps));
  sum += square(scales_.health * double(x.health - y.health));
  sum += square(kTargetStuds * stepsBetween(x, y));
  for (size_t i = 0; scales_.body > 0 && i < playOf(a).bodies.size(); ++i) {
    const Vec3 apart = playOf(a).bodies[i].position - playOf(b).bodies[i].position;
    sum += square(scales_.body) * double(dot(apart, apart));
  }
  return std::sqrt(sum);
}

// SST does not interpolate, and no state between two others would be one of the game.
void PlaySpace::interpolate(const ob::State* from, const ob::State* to, double t,
                            ob::State* state) const {
  copyState(state, t < 0.5 ? from : to);
}

ob::StateSamplerPtr PlaySpace::allocDefaultStateSampler() const {
  return std::make_shared<PlaySampler>(*this);
}

Vec3 PlaySpace::drawIn(const Box& box) const {
  const auto draw = [this](float lo, float hi) { return lo + (hi - lo) * random_.unit(); };
  const float x = draw(box.lo.x, box.hi.x), y = draw(box.lo.y, box.hi.y);
  return {x, y, draw(box.lo.z, box.hi.z)};
}

Vec3 PlaySpace::drawPosition() const {
  if (floors_.empty() || random_.unit() < 0.5f) {
    Box box = problem_.bounds;
    box.hi.y += kHeadroom;
    return drawIn(box);
  }
  Box floor = floors_[random_.below(uint32_t(floors_.size()))];
  floor.lo.y = floor.hi.y;
  return drawIn(floor);
}

void PlaySpace::drawOthers(Play& state, const Seen::Progress& progress) const {
  sim::World& world = state.world;
  world = problem_.start;
  const float walk = problem_.level.params.walkSpeed, leap = problem_.level.params.jumpSpeed;
  world.velocity = drawIn({{-walk, -leap, -walk}, {walk, leap, walk}});
  if (random_.unit() < 0.5f) world.velocity.y = 0;  // most players stand
  world.tick = seen_.firstTick + random_.below(seen_.lastTick - seen_.firstTick + kTicksAhead);
  world.jumps = uint16_t(random_.below(seen_.jumps + 1u));
  world.waypoints = progress.waypoints;
  world.visited = progress.visited;
  state.bodies = seen_.bodies[random_.below(uint32_t(seen_.bodies.size()))];
}

void PlaySpace::sample(Play& state) const {
  drawOthers(state, seen_.progress[random_.below(uint32_t(seen_.progress.size()))]);
  state.world.position = drawPosition();
}

void PlaySpace::sampleNext(Play& state) const {
  drawOthers(state, seen_.progress.back());
  state.world.position = drawPosition();  // so that each of several next regions is drawn
  const geom::Region& region = *sim::nextRegion(problem_.query, state.world).region;
  state.world.position = toWorld(region.pose, drawIn({-region.half, region.half}));
}

bool KeysSpace::equalControls(const oc::Control* a, const oc::Control* b) const {
  return solve::sameKeys(actionOf(a), actionOf(b));
}

oc::ControlSamplerPtr KeysSpace::allocDefaultControlSampler() const {
  return std::make_shared<KeysSampler>(*this, mayJump_, seed_);
}

}  // namespace obby::bench
