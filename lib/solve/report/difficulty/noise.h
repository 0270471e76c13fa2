// Models a player who knows the route, and the size of the player's errors. All numbers are
// assumptions until they are fitted to recordings of people. So the order of two solutions means
// more than any share of trials.
#pragma once

#include <string>

namespace obby::solve {

struct NoiseModel {
  const char* name = "average player";
  // Time error of a key press, standard deviation, seconds. People who time a press to something
  // that approaches err by about a tenth of the time for which they see it (Lee and Oulasvirta
  // 2016).
  float press = 0.030f;
  // Error of the walk direction, standard deviation, degrees.
  float aim = 6;
  // Time from seeing a deviation to a change of direction, seconds.
  float reaction = 0.250f;
  // Max offset from the recorded position at the start, studs along X and Z.
  float place = 0.2f;
  // Time for which the jump key is held, seconds.
  float hold = 0.1f;
};

// Returns text like "average player: press error 30 ms, aim error 6 degrees, ...".
std::string describe(const NoiseModel& model);

}  // namespace obby::solve
