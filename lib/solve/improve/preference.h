// The weights of a trajectory's cost, and named sets of them. A solution is better if it costs
// less.
#pragma once

#include <span>
#include <string_view>

namespace obby::solve {

// Prices in seconds of play. A trajectory may take that much longer to avoid one unit.
struct CostWeights {
  float second;   // per second of play
  float jump;     // per jump
  float turn;     // per radian by which the direction of movement turns
  float change;   // per change of the keys held
  float hazard;   // per second right next to a part that kills
  float edge;     // per second on the edge of the part that carries the player
  float landing;  // per landing on an edge
  float press;    // per press of a jump, a little early or late, that misses the landing
};

struct Preference {
  const char* name;
  const char* description;
  CostWeights weights;
};

// Returns all preferences, the default first.
std::span<const Preference> preferences();

// Returns nullptr if there is no such preference.
const Preference* findPreference(std::string_view name);

}  // namespace obby::solve
