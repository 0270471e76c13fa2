#include "solve/answer/earlier_answers.h"

#include <optional>

#include "sim/simulator.h"
#include "solve/model/retimed.h"

namespace obby::solve {

Result<EarlierAnswers> EarlierAnswers::read(io::SourceOptions source) {
  EarlierAnswers answers;
  io::RecordSource records(std::move(source));
  for (;;) {
    OBBY_ASSIGN(const std::optional<io::Record> record, records.next());
    if (!record) return answers;
    if (!record->known() || record->which() != io::Kind::TRAJECTORY) continue;
    if (Status noted = answers.note(record->reader().getTrajectory()); !noted) {
      OBBY_RETURN_IF_ERROR(records.forgive(*record, noted.error()));
    }
  }
}

Status EarlierAnswers::note(schema::Trajectory::Reader trajectory) {
  OBBY_ASSIGN(level::Player player, level::playerOf(trajectory));
  OBBY_ASSIGN(sim::Plan plan, sim::planFromRecord(trajectory));
  trajectories_[{trajectory.getLevel(), trajectory.getQuery()}].push_back(
      {std::move(player), std::move(plan.actions)});
  return {};
}

std::vector<ActionRuns> EarlierAnswers::trajectoriesOf(const std::string& level,
                                                       const std::string& query,
                                                       const For& who) const {
  std::vector<ActionRuns> own, others;
  const auto found = trajectories_.find({level, query});
  if (found == trajectories_.end()) return own;
  for (const PlayerTrajectory& earlier : found->second) {
    const uint32_t from = earlier.player.frameRate != 0 ? earlier.player.frameRate : who.levelRate;
    (earlier.player == who.player ? own : others).push_back(retimed(earlier.runs, from, who.rate));
  }
  own.insert(own.end(), others.begin(), others.end());
  return own;
}

void EarlierAnswers::forget(const std::string& level, const std::string& query) {
  trajectories_.erase({level, query});
}

}  // namespace obby::solve
