#include "calibrate/frame_play.h"

#include <algorithm>
#include <cmath>

#include "calibrate/playback.h"
#include "sim/tick.h"

namespace obby::calibrate {

namespace {

constexpr double kOffStep = 0.15;   // max rounding error of a frame's length, physics steps
constexpr int kOffCount = 2;        // max correction of a frame's steps by its motion
constexpr float kOffPlace = 4e-3f;  // studs: an error below this confirms a number of steps, an
                                    // error above four times this excludes it
constexpr size_t kAround = 16;      // frames on each side from which the frame rate is fitted
constexpr double kUneven = 1.5;  // steps: a larger deviation from the fitted line means an unsteady
                                 // rate
constexpr float kSlack = 0.2f;   // rounding error of a sum of mean frames, steps

// Returns the steps that fit a frame's motion on the floor under constant acceleration, or `steps`
// if the motion does not decide.
uint32_t stepsByMotion(const Frame& a, const Frame& b, uint32_t steps, float dt) {
  if (a.state != sim::State::running || b.state != sim::State::running) return steps;
  const auto offAt = [&](int n) {
    const Vec3 travel =
        (a.velocity * float(n) + (b.velocity - a.velocity) * (0.5f * float(n + 1))) * dt;
    const Vec3 off = b.position - a.position - travel;
    return std::hypot(off.x, off.z);
  };
  int best = int(steps);
  for (int n = std::max(1, best - kOffCount); n <= int(steps) + kOffCount; ++n) {
    if (offAt(n) < offAt(best)) best = n;
  }
  return offAt(best) < kOffPlace && offAt(int(steps)) > 4 * kOffPlace ? uint32_t(best) : steps;
}

// Returns the steps per frame by linear regression, or 0 if the frames are not steady.
double steadyRate(const uint32_t* steps, size_t count) {
  const size_t n = count + 1;
  std::vector<double> time(n, 0);
  for (size_t i = 0; i < count; ++i) time[i + 1] = time[i] + steps[i];
  const double middle = 0.5 * double(count);
  double product = 0, square = 0;
  for (size_t i = 0; i < n; ++i) {
    product += (double(i) - middle) * time[i];
    square += (double(i) - middle) * (double(i) - middle);
  }
  const double rate = product / square;
  for (size_t i = 0; i < n; ++i) time[i] -= rate * double(i);
  const auto [min, max] = std::minmax_element(time.begin(), time.end());
  return *max - *min <= kUneven ? rate : 0;
}

// Counts the time in Landed by the frames' own time, and by their steps where that is ambiguous.
class LandedClock {
 public:
  explicit LandedClock(const sim::World& w) : left_(w.landedSteps), stepsLeft_(w.landedSteps) {}

  void beforeTick(sim::World& w, uint32_t steps, float own) {
    landed_ = w.state == sim::State::landed;
    if (!landed_) return;
    pass(steps, own);
    const bool over = left_ <= -kSlack || (left_ <= kSlack && stepsLeft_ <= 0);
    w.landedSteps = uint8_t(over ? steps : steps + 1);
  }
  // The landing frame counts.
  void afterTick(const sim::World& w, const Params& p, uint32_t steps, float own) {
    if (landed_ || w.state != sim::State::landed) return;
    left_ = float(p.landedSteps);
    stepsLeft_ = p.landedSteps;
    pass(steps, own);
  }

 private:
  void pass(uint32_t steps, float own) {
    left_ -= own;
    stepsLeft_ -= int(steps);
  }

  float left_;
  int stepsLeft_;
  bool landed_ = false;
};

bool onFloor(const sim::World& w) {
  return (w.state == sim::State::running || w.state == sim::State::landed) &&
         (w.flags & sim::kFloorSensed);
}

// A player whose centre of mass may differ from the root's centre. On a floor the legs drive the
// root and the centre of mass swings about it. In the air the root swings about the centre of mass.
// World::velocity belongs to the driven point.
class Walker {
 public:
  Walker(const level::LevelView& level, const sim::World& world, const MassCentre& centre,
         sim::Action first)
      : world_(world), bodies_(sim::startBodies(level)), centre_(centre) {
    if (centre_.isRoot() || !onFloor(world_)) return;
    rate_ = turnRate(ticked(world_, level, first), level);
    world_.velocity -= rate_;  // the recorded velocity is that of the centre of mass
  }

  sim::World& world() { return world_; }

  void tick(const level::LevelView& level, sim::Action action) {
    if (centre_.isRoot()) {
      sim::tick(world_, bodies_.data(), level, action);
      return;
    }
    sim::World next = ticked(world_, level, action);
    const bool drivesRoot = onFloor(next);
    if (drivesRoot != onFloor(world_)) {
      sim::World begin = world_;
      begin.velocity += drivesRoot ? -turnRate(next, level) : rate_;
      next = ticked(begin, level, action);
    }
    rate_ = turnRate(next, level);
    if (!onFloor(next)) next.position -= rate_ * level.params.tickSeconds;
    world_ = next;
  }

 private:
  // Pushed bodies do not move, since recordings of real places have none.
  sim::World ticked(sim::World w, const level::LevelView& level, sim::Action action) {
    std::vector<sim::RigidBody> bodies = bodies_;
    sim::tick(w, bodies.data(), level, action);
    return w;
  }
  // Returns the velocity of the centre of mass relative to the root, in a tick that ends in `next`.
  Vec3 turnRate(const sim::World& next, const level::LevelView& level) const {
    return (centre_.at(next.yaw) - centre_.at(world_.yaw)) * (1 / level.params.tickSeconds);
  }

  sim::World world_;
  std::vector<sim::RigidBody> bodies_;
  MassCentre centre_;
  Vec3 rate_;  // turnRate() of the last tick, studs/s
};

}  // namespace

uint32_t stepsBetween(const Frame& a, const Frame& b, double stepsPerSecond) {
  const double steps = (b.time - a.time) * stepsPerSecond, whole = std::floor(steps + 0.5);
  return whole < 1 || std::abs(steps - whole) > kOffStep ? 0 : uint32_t(whole);
}

std::vector<uint32_t> stepsOf(const Track& track, double stepsPerSecond) {
  std::vector<uint32_t> out;
  for (size_t i = 0; i + 1 < track.frames.size(); ++i) {
    const Frame &a = track.frames[i], &b = track.frames[i + 1];
    const uint32_t steps = stepsBetween(a, b, stepsPerSecond);
    if (steps == 0 || steps > kMaxSteps) return {};
    out.push_back(std::min(stepsByMotion(a, b, steps, float(1 / stepsPerSecond)), kMaxSteps));
  }
  return out;
}

std::vector<float> ownSteps(const std::vector<uint32_t>& steps) {
  std::vector<float> out;
  for (size_t i = 0; i < steps.size(); ++i) {
    const size_t from = i - std::min(i, kAround), to = std::min(steps.size(), i + kAround + 1);
    const double rate = steadyRate(steps.data() + from, to - from);
    out.push_back(rate > 0 ? float(rate) : float(steps[i]));
  }
  return out;
}

std::vector<Played> playFrames(level::LevelView view, const Track& track,
                               const std::vector<uint32_t>& steps, const MassCentre& centre) {
  const float step = view.params.substepSeconds;
  const auto takesSteps = [&](uint32_t n) {
    view.params.substeps = uint16_t(n);
    view.params.tickSeconds = step * float(n);
  };
  const sim::World start = worldAt(track, 0, view);
  if (!steps.empty()) takesSteps(steps[0]);
  Walker walker(view, start, centre, actionOf(track.frames[0]));
  LandedClock landed(start);
  const std::vector<float> own = ownSteps(steps);
  std::vector<Played> out{{track.frames[0].position, track.frames[0].state}};
  for (size_t i = 0; i < steps.size(); ++i) {
    takesSteps(steps[i]);
    landed.beforeTick(walker.world(), steps[i], own[i]);
    walker.tick(view, actionOf(track.frames[i]));
    landed.afterTick(walker.world(), view.params, steps[i], own[i]);
    out.push_back({rootOf(walker.world().position, view.params), walker.world().state});
  }
  return out;
}

}  // namespace obby::calibrate
