// The model of a player who knows the way, and how far off what the player does is. All numbers are
// assumptions until they are fitted to recordings of people: the order of two solutions by it means
// more than any share of trials.
#pragma once

#include <string>

#include "base/random.h"

namespace obby::solve {

struct NoiseModel {
  const char* name = "average player";
  // When a key goes down against when it should, standard deviation, seconds. Of people who time a
  // press to what they see come, about a tenth of the time they see it for (Lee and Oulasvirta
  // 2016).
  float press = 0.030f;
  // Direction walked against the one that is meant, standard deviation, degrees.
  float aim = 6;
  // From seeing something to doing something about it, seconds: the choice of a direction.
  float reaction = 0.250f;
  // Where the player stands against where the recorded one does, at most, studs along X and Z.
  float place = 0.2f;
  // For how long the jump key is held, seconds.
  float hold = 0.1f;
};

// "average player: press error 30 ms, aim error 6 degrees, ...".
std::string describe(const NoiseModel& model);

// Near enough a normal distribution of mean 0 and standard deviation 1, without libm: the sum of
// twelve uniform numbers. Never beyond 6.
inline float gaussian(Random& random) {
  float sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

}  // namespace obby::solve
