// A player who repeats a segment of a solution as well as a person might: who means to press the
// recorded keys at the recorded places and walk the recorded path, but presses early or late and
// walks a little aside, sees that only after the time that a reaction takes, and then sets it
// right.
#pragma once

#include <span>
#include <vector>

#include "solve/report/difficulty/leg.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

class NoisyPlayer {
 public:
  // Presses exactly and walks exactly; `shifts`: ticks by which each jump of the leg is pressed
  // later (or earlier) than recorded.
  NoisyPlayer(const Leg& leg, const NoiseModel& model, std::span<const int32_t> shifts);
  // The same with the noise of the model, drawn from `random`.
  NoisyPlayer(const Leg& leg, const NoiseModel& model, std::span<const int32_t> shifts,
              const Random& random);

  // What is held in the next tick by a player whose world is `world`. To be called once a tick,
  // from the leg's start on.
  sim::Action next(const sim::World& world);

 private:
  float ticksOf(float seconds) const {
    return seconds * float(leg_->problem.level.params.controlRate);
  }
  int32_t late();
  int32_t place() const { return int32_t(tick_) - lag_; }
  void look(const sim::World& world);
  sim::Action walk(const sim::World& world) const;
  sim::Action hold(const sim::World& world) const;
  bool jumps(const sim::World& world);

  const Leg* leg_;
  NoiseModel model_;
  Random random_{0, 0};
  bool noisy_ = false;
  std::vector<int32_t> presses_;  // ticks of the leg
  size_t pressed_ = 0;            // of them, that are over
  int32_t holdTicks_, lookEvery_;
  uint32_t tick_ = 0;
  int32_t lag_ = 0;     // ticks behind the recorded player
  int32_t held_ = 0;    // ticks for which the jump key has been held
  int32_t jumped_ = 0;  // jumps made when it went down
  Turns aside_ = 0;     // error of aim until the next look
  // At the last look: how far the player was from the recorded place, and what was decided. It
  // takes a reaction until that shows, so the next decision is about this.
  Vec3 seen_, decided_;
  Vec3 sideways_;  // studs to walk beside the recorded way until the next look
};

}  // namespace obby::solve
