// The answers of a stream, gathered from its records as they go by.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "table/answer.h"

namespace obby::table {

class Gathering {
 public:
  void add(schema::Record::Reader record);

  // In the order in which the stream first names their queries.
  const std::vector<Answer>& answers() const { return answers_; }

 private:
  void addQuery(schema::Query::Reader query);
  void addResult(schema::Result::Reader result);
  // Found on the way to an answer.
  void addFound(const std::string& query, const std::string& level);
  // An empty name is that of the last level.
  const std::string& levelName(const std::string& name) const;
  const LevelFacts* levelNamed(const std::string& name) const;
  Answer& answerTo(const std::string& query, const std::string& level);

  std::vector<Answer> answers_;
  std::map<std::pair<std::string, std::string>, size_t> byName_;  // level and query
  std::map<std::string, LevelFacts> levels_;
  std::string last_;  // level
};

}  // namespace obby::table
