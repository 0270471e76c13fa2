#include "solve/report/relaxation/knobs.h"

#include <iterator>

namespace obby::solve {

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> table = {
      {limitChanges},    {jumpHeightChanges}, {loweredChanges},
      {killPartChanges}, {avoidChanges},      {forbiddenChanges},
  };
  return table;
}

std::vector<Change> changesFor(const Failure& failure) {
  std::vector<Change> all;
  for (const Knob& knob : knobs()) {
    std::vector<Change> some = knob.changes(failure);
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace obby::solve
