#include "table/gathering.h"

namespace obby::table {

void Gathering::add(schema::Record::Reader record) {
  switch (record.which()) {
    case schema::Record::LEVEL:
      last_ = record.getLevel().getName();
      levels_.insert_or_assign(last_, factsOf(record.getLevel()));
      return;
    case schema::Record::QUERY: return addQuery(record.getQuery());
    case schema::Record::RESULT: return addResult(record.getResult());
    case schema::Record::TRAJECTORY: {
      const auto trajectory = record.getTrajectory();
      return addFound(trajectory.getQuery(), trajectory.getLevel());
    }
    case schema::Record::PROGRESS: {
      const auto progress = record.getProgress();
      return addFound(progress.getQuery(), progress.getBest().getLevel());
    }
    default: return;
  }
}

void Gathering::addQuery(schema::Query::Reader query) {
  Answer& answer = answerTo(query.getId(), query.getLevel());
  describe(query, levelNamed(answer.level), answer);
}

void Gathering::addResult(schema::Result::Reader result) {
  Answer& answer = answerTo(result.getQuery(), result.getLevel());
  const LevelFacts* const level = levelNamed(answer.level);
  describe(result, level ? level->controlRate : LevelFacts().controlRate, answer);
}

void Gathering::addFound(const std::string& query, const std::string& level) {
  Answer& answer = answerTo(query, level);
  if (answer.state == State::notAsked) answer.state = State::noResult;
}

const std::string& Gathering::levelName(const std::string& name) const {
  return name.empty() ? last_ : name;
}

const LevelFacts* Gathering::levelNamed(const std::string& name) const {
  const auto found = levels_.find(name);
  return found == levels_.end() ? nullptr : &found->second;
}

Answer& Gathering::answerTo(const std::string& query, const std::string& level) {
  const std::string& name = levelName(level);
  const auto [at, fresh] = byName_.try_emplace({name, query}, answers_.size());
  if (fresh) {
    answers_.emplace_back();
    answers_.back().query = query;
    answers_.back().level = name;
  }
  return answers_[at->second];
}

}  // namespace obby::table
