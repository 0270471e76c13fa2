// A player who repeats a segment of a solution as well as a person might. The player means to press
// the recorded keys at the recorded places and to walk the recorded path. Presses come early or
// late, and walks are a little off. The player sees an error only after a reaction time, and then
// corrects it.
#pragma once

#include <span>
#include <vector>

#include "base/random.h"
#include "solve/report/difficulty/last_segments.h"
#include "solve/report/difficulty/noise.h"

namespace obby::solve {

class NoisyPlayer {
 public:
  // Presses and walks exactly. `shifts`: ticks by which each jump is pressed later than recorded;
  // negative is earlier.
  NoisyPlayer(const LastSegments& rest, const NoiseModel& model, std::span<const int32_t> shifts);
  // Adds the noise of the model, drawn from `random`.
  NoisyPlayer(const LastSegments& rest, const NoiseModel& model, std::span<const int32_t> shifts,
              const Random& random);

  // Returns the action for the next tick of a player whose world is `world`. Must be called once
  // per tick, from the start of the segment on.
  sim::Action next(const sim::World& world);

 private:
  float ticksOf(float seconds) const {
    return seconds * float(rest_->problem.level.params.controlRate);
  }
  int32_t late();
  int32_t place() const { return int32_t(tick_) - lag_; }
  void look(const sim::World& world);
  sim::Action walk(const sim::World& world) const;
  sim::Action hold(const sim::World& world) const;
  bool jumps(const sim::World& world);

  const LastSegments* rest_;
  NoiseModel model_;
  Random random_{0, 0};
  bool noisy_ = false;
  std::vector<int32_t> presses_;  // ticks of the segment at which jumps are pressed
  size_t pressed_ = 0;            // presses that are over
  int32_t holdTicks_, lookEvery_;
  uint32_t tick_ = 0;
  int32_t lag_ = 0;     // ticks behind the recorded player
  int32_t held_ = 0;    // ticks for which the jump key has been held
  int32_t jumped_ = 0;  // jumps made when the key went down
  Turns aside_ = 0;     // aim error until the next look
  // The offset from the recorded place at the last look, and the correction decided then. The
  // correction takes a reaction time to show, so the next decision is based on these.
  Vec3 seen_, decided_;
  Vec3 sideways_;  // correction to walk until the next look, studs
};

}  // namespace obby::solve
