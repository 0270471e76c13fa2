// Moves of the player away from all parts, for scripts that watch them. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

struct Move {
  Probe probe;
  std::vector<Probe> targets;  // targets of probes after the move
};

class Moves {
 public:
  Moves(Stage& stage, const Plan& plan, Children& children)
      : stage_(stage), plan_(plan), children_(children) {}

  // If scripts watch the player's moves, it walks, jumps twice, falls and enters other states, each
  // in a copy of the place. If they watch its position, it stands away from all parts.
  void run(std::vector<Probe>& moves);
  // Adds parts whose position scripts read only after the player moved.
  void addTargets(std::vector<Probe>& wanted) const;

 private:
  Stage& stage_;
  const Plan& plan_;
  Children& children_;
  std::vector<Probe> found_;
};

}  // namespace obby::engine
