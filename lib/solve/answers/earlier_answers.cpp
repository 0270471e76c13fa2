#include "solve/answers/earlier_answers.h"

#include <optional>

#include "sim/simulator.h"

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
  OBBY_ASSIGN(sim::Plan plan, sim::planFromRecord(trajectory));
  ways_[{trajectory.getLevel(), trajectory.getQuery()}].push_back(std::move(plan.actions));
  return {};
}

const std::vector<KnownWay>& EarlierAnswers::waysOf(const std::string& level,
                                                    const std::string& query) const {
  static const std::vector<KnownWay> kNoWays;
  const auto found = ways_.find({level, query});
  return found == ways_.end() ? kNoWays : found->second;
}

void EarlierAnswers::forget(const std::string& level, const std::string& query) {
  ways_.erase({level, query});
}

}  // namespace obby::solve
