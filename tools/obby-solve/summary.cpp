#include "summary.h"

#include <fmt/format.h>

namespace obby::tools {

namespace {

std::string countsText(solve::Task task, const solve::FilterCounts& c) {
  switch (task) {
    case solve::Task::verify:
      return fmt::format("{} {} as recorded", c.verified,
                         c.verified == 1 ? "trajectory replays" : "trajectories replay");
    case solve::Task::filter:
      return fmt::format("kept {} of {} trajectories", c.kept, c.kept + c.dropped);
    case solve::Task::answer: break;
  }
  return fmt::format("{} solved, {} unreachable, {} unknown", c.solved, c.unreachable, c.unknown);
}

}  // namespace

std::string summary(solve::Task task, const RunOutcome& outcome) {
  return fmt::format("{} in {:.{}f} s", countsText(task, outcome.counts), outcome.seconds,
                     outcome.seconds < 1 ? 2 : 1);
}

bool RunOutcome::isEmpty() const {
  const solve::FilterCounts& c = counts;
  return c.solved + c.unreachable + c.unknown + c.verified + c.kept + c.dropped == 0;
}

}  // namespace obby::tools
