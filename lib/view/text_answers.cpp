// The rows of the table: the recorded results, corrected by the replays of their trajectories.
#include <utility>

#include "view/text_report.h"

namespace obby::view {
namespace {

void addReplays(const QueryEntry& query, table::Answer& answer) {
  if (!query.paths.empty() && answer.state == table::State::notAsked) {
    answer.state = table::State::noResult;
  }
  for (const PathEntry& path : query.paths) {  // solutions come first and decide the verdict
    const std::string& mismatch = path.playback.mismatch;
    if (mismatch.empty()) continue;
    if (path.kind == PathKind::solution) {
      answer.state = table::State::mismatch;
      answer.reason = "its solution cannot be reproduced by replaying it: " + mismatch;
    } else {
      answer.reason += answer.reason.empty() ? "" : " ";
      answer.reason += "(an attempt cannot be reproduced by replaying it: " + mismatch + ")";
    }
    return;
  }
}

}  // namespace

std::vector<table::Answer> answersOf(const Report& report) {
  std::vector<table::LevelFacts> levels;
  for (const LevelEntry& level : report.levels) levels.push_back(table::factsOf(level.reader()));
  std::vector<table::Answer> answers;
  for (const QueryEntry& query : report.queries) {
    const table::LevelFacts* const level =
        query.level >= 0 ? &levels[size_t(query.level)] : nullptr;
    table::Answer answer;
    answer.query = query.id;
    if (level) answer.level = level->name;
    if (query.query) table::describe(query.reader(), level, answer);
    if (query.progress) answer.state = table::State::noResult;
    if (query.result) {
      const double rate = level ? level->controlRate : table::LevelFacts().controlRate;
      table::describe(query.answer(), rate, answer);
    }
    addReplays(query, answer);
    answers.push_back(std::move(answer));
  }
  return answers;
}

}  // namespace obby::view
