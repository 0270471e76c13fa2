// Gathers the answers of a stream from its records, one by one.
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

  // Returns the answers in the order in which the stream first names their queries.
  const std::vector<Answer>& answers() const { return answers_; }

 private:
  void addQuery(schema::Query::Reader query);
  void addResult(schema::Result::Reader result);
  // Notes that the stream has a trajectory or progress of the query, so the query was asked.
  void addFound(const std::string& query, const std::string& level);
  // Returns `name`, or the name of the last level if it is empty.
  const std::string& levelName(const std::string& name) const;
  const LevelFacts* levelNamed(const std::string& name) const;
  Answer& answerTo(const std::string& query, const std::string& level);

  std::vector<Answer> answers_;
  std::map<std::pair<std::string, std::string>, size_t> byName_;  // level and query
  std::map<std::string, LevelFacts> levels_;
  std::string last_;  // name of the last level
};

}  // namespace obby::table
