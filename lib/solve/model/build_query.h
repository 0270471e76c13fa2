// Builds query records from the command line, or from the level's own spawns and goals.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::solve {

// A query in terms of places: selectors of parts (level/select_parts.h), boxes, or touch:SELECTOR
// if the part itself must be touched. Fields at their defaults have no effect.
struct QuickQuery {
  std::string start;
  std::vector<std::string> goals;      // any of them
  std::vector<std::string> waypoints;  // in order
  std::vector<std::string> visits;     // in any order; a #tag stands for all its parts
  std::vector<std::string> avoid;      // a name stands for all parts that it matches
  std::string arrive;                  // an enumerant of schema Arrive; empty: as the query says
  std::vector<std::string> forbid;     // enumerants of schema PlayerState
  std::vector<std::string> tricks;     // names from level::trickOptions()
  std::string directions;  // an enumerant of schema Directions; empty: as the query says
  int32_t minJumps = -1, maxJumps = -1;
  float timeLimit = 0;  // seconds
  float maxDamage = -1;
};

// Returns true if the level has a part where it ends. That part is the goal of a query without one.
bool hasEnd(schema::Level::Reader level);
// Returns the error for a query without a goal in a level without an end. Its path is the first
// option that `quick` sets. `queries`: number of queries that the stream has for the level.
Error lacksGoal(schema::Level::Reader level, const QuickQuery& quick, uint64_t queries);

// Returns a query record with the id `id`. The default start is the level's first spawn. The
// default goal is its goal part, or else its last checkpoint. Error: a selector matches no part or
// several, or the level lacks a spawn or goal. The error's path is the option.
Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id);

// Returns a query record that has only places: `pass` as visits, `notPass` as places to avoid.
// Errors are as above, with the options --pass and --not-pass.
Result<io::Record> buildPlaces(schema::Level::Reader level, const std::vector<std::string>& pass,
                               const std::vector<std::string>& notPass);

// Returns the query with the fields that `quick` sets replaced. Errors are as above.
Result<io::Record> changeQuery(schema::Level::Reader level, const QuickQuery& quick,
                               const io::Record& query);

}  // namespace obby::solve
