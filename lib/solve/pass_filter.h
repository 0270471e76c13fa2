// Filters existing trajectories by the places that they pass.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/verify/place.h"

namespace obby::solve {

// Selectors in the syntax of a QuickQuery. A #tag stands for all its parts.
struct PassRule {
  std::vector<std::string> pass;     // all must be passed, in any order
  std::vector<std::string> notPass;  // none may be passed
  bool empty() const { return pass.empty() && notPass.empty(); }
};

// A rule resolved to the places of one level. Boxes are tested between ticks, too, and parts at the
// end of each tick.
class PassFilter {
 public:
  // `level` is compiled from `record`. Error: a selector matches no part, or several; its path
  // names the option.
  static Result<PassFilter> make(schema::Level::Reader record, const level::Level& level,
                                 const PassRule& rule);

  // Replays the trajectory and returns true if it obeys the rule. Error: its actions are not a
  // plan.
  Result<bool> keeps(const level::Level& level, schema::Trajectory::Reader trajectory) const;

 private:
  std::vector<Place> pass_, notPass_;
};

}  // namespace obby::solve
