// The player's moves away from all parts, where scripts look at them. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

struct Move {
  Probe probe;
  std::vector<Probe> targets;  // what a probe may go to, by then
};

class Moves {
 public:
  Moves(Stage& stage, const Plan& plan, Children& children)
      : stage_(stage), plan_(plan), children_(children) {}

  // Walks, jumps twice, falls and exerts itself, each in a copy of the place, if scripts look at
  // moves; stands away from all parts if they look at where the player is.
  void run(std::vector<Probe>& moves);
  // Adds parts that scripts looked at only once the player moved.
  void addTargets(std::vector<Probe>& wanted) const;

 private:
  Stage& stage_;
  const Plan& plan_;
  Children& children_;
  std::vector<Probe> found_;
};

}  // namespace obby::engine
