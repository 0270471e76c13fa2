#include "solve/model/retimed.h"

#include "level/player.h"

namespace obby::solve {

ActionRuns retimed(const ActionRuns& runs, uint32_t from, uint32_t to) {
  if (from == to) return runs;
  ActionRuns result;
  uint32_t end = 0, toEnd = 0;  // end of the runs so far, at each rate
  for (const sim::ActionRun& run : runs) {
    end += run.ticks;
    const uint32_t next = level::nextTickAtRate(end, from, to);
    if (next > toEnd) result.push_back({run.action, next - toEnd});
    toEnd = next;
  }
  return result;
}

}  // namespace obby::solve
