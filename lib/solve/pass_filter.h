// Choosing among playthroughs that are already there, by where they pass.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/verify/place.h"

namespace obby::solve {

// Selectors as of a QuickQuery; a #tag stands for all its parts.
struct PassRule {
  std::vector<std::string> pass;     // all of them, in any order
  std::vector<std::string> notPass;  // none of them
  bool empty() const { return pass.empty() && notPass.empty(); }
};

// A rule in the places of one level. A box is passed between two ticks, too; a part is touched at
// the end of one.
class PassFilter {
 public:
  // `level` is compiled from `record`. Error: a selector that fits no part, or several; its path is
  // the option.
  static Result<PassFilter> make(schema::Level::Reader record, const level::Level& level,
                                 const PassRule& rule);

  // Replays the trajectory. Error: its actions are no plan.
  Result<bool> keeps(const level::Level& level, schema::Trajectory::Reader trajectory) const;

 private:
  std::vector<Place> pass_, notPass_;
};

}  // namespace obby::solve
