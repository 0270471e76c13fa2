// The game as a planning problem of OMPL: its states, its controls and their samplers. A state is
// one world of the simulator, and a control is a set of keys.
#pragma once

#include <ompl/control/ControlSpace.h>

#include <deque>
#include <vector>

#include "base/random.h"
#include "solve/model/problem.h"

namespace obby::bench {

struct Play {
  sim::World world{};
  std::vector<sim::RigidBody> bodies;
};

struct PlayState : ompl::base::State {
  Play play;
};

inline const Play& playOf(const ompl::base::State* state) {
  return static_cast<const PlayState*>(state)->play;
}
inline Play& playOf(ompl::base::State* state) { return static_cast<PlayState*>(state)->play; }

struct KeysControl : ompl::control::Control {
  sim::Action action;
};

inline sim::Action& actionOf(ompl::control::Control* control) {
  return static_cast<KeysControl*>(control)->action;
}
inline const sim::Action& actionOf(const ompl::control::Control* control) {
  return static_cast<const KeysControl*>(control)->action;
}

// The parts of a state that only the simulator can change, as far as any state has come.
struct Seen {
  struct Progress {
    uint8_t waypoints;
    uint32_t visited;
    bool operator==(const Progress&) const = default;
  };

  explicit Seen(const solve::Problem& problem);
  // Must be called after every tick.
  void note(const sim::World& world, const std::vector<sim::RigidBody>& bodies);

  uint64_t ticks = 0;                               // number of calls
  uint32_t firstTick, lastTick;                     // level clock
  uint16_t jumps = 0;                               // max
  std::vector<Progress> progress;                   // distinct; the furthest last
  std::vector<std::vector<sim::RigidBody>> bodies;  // a few of the most recent
};

// Lends objects and reclaims all of them on destruction, since SST does not return all that it
// allocates.
template <class T>
class Pool {
 public:
  T* lend() {
    if (free_.empty()) return &all_.emplace_back();
    T* const object = free_.back();
    free_.pop_back();
    return object;
  }
  void reclaim(T* object) { free_.push_back(object); }

 private:
  std::deque<T> all_;
  std::vector<T*> free_;
};

// The worlds of a problem. The distance is Euclidean, in studs. Other quantities are scaled to
// studs; they count only if the problem depends on them.
class PlaySpace : public ompl::base::StateSpace {
 public:
  // Both must outlive the space.
  PlaySpace(const solve::Problem& problem, const Seen& seen, uint64_t seed);

  unsigned int getDimension() const override { return 7; }
  double getMaximumExtent() const override;
  double getMeasure() const override { return 1; }
  void enforceBounds(ompl::base::State*) const override {}
  bool satisfiesBounds(const ompl::base::State*) const override { return true; }
  void copyState(ompl::base::State* to, const ompl::base::State* from) const override {
    playOf(to) = playOf(from);
  }
  double distance(const ompl::base::State* a, const ompl::base::State* b) const override;
  bool equalStates(const ompl::base::State* a, const ompl::base::State* b) const override {
    return distance(a, b) == 0;
  }
  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override;
  ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;
  ompl::base::State* allocState() const override { return states_.lend(); }
  void freeState(ompl::base::State* state) const override {
    states_.reclaim(static_cast<PlayState*>(state));
  }

  // Draws a state on or above the level, with a progress that some state has.
  void sample(Play& state) const;
  // Draws a state in a region that states of the furthest progress must reach next.
  void sampleNext(Play& state) const;

 private:
  struct Scales {  // studs per unit
    double velocity, tick, jump, health, body;
  };

  Vec3 drawIn(const Box& box) const;
  Vec3 drawPosition() const;
  void drawOthers(Play& state, const Seen::Progress& progress) const;

  const solve::Problem& problem_;
  const Seen& seen_;
  const Scales scales_;
  std::vector<Box> floors_;  // bounds of solid parts
  mutable Random random_;
  mutable Pool<PlayState> states_;
};

// The keys of a player: a heading, and whether move and jump keys are held.
class KeysSpace : public ompl::control::ControlSpace {
 public:
  KeysSpace(const ompl::base::StateSpacePtr& states, bool mayJump, uint64_t seed)
      : ControlSpace(states), mayJump_(mayJump), seed_(seed) {}

  unsigned int getDimension() const override { return 3; }
  ompl::control::Control* allocControl() const override { return controls_.lend(); }
  void freeControl(ompl::control::Control* control) const override {
    controls_.reclaim(static_cast<KeysControl*>(control));
  }
  void copyControl(ompl::control::Control* to, const ompl::control::Control* from) const override {
    actionOf(to) = actionOf(from);
  }
  bool equalControls(const ompl::control::Control* a,
                     const ompl::control::Control* b) const override;
  void nullControl(ompl::control::Control* control) const override { actionOf(control) = {}; }
  ompl::control::ControlSamplerPtr allocDefaultControlSampler() const override;

 private:
  const bool mayJump_;
  const uint64_t seed_;
  mutable Pool<KeysControl> controls_;
};

}  // namespace obby::bench
