// Builds query records from the command line, or from what the level says about itself.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::solve {

// A query in terms of places: selectors of parts (level/select_parts.h), boxes, or touch:SELECTOR
// if the part itself has to be touched. Empty or negative fields ask for nothing.
struct QuickQuery {
  std::string start;
  std::vector<std::string> goals;      // any of them
  std::vector<std::string> waypoints;  // in order
  std::vector<std::string> visits;     // in any order; a #tag stands for all its parts
  std::vector<std::string> avoid;      // a name stands for all parts that it matches
  std::string arrive;                  // as the schema spells it; empty: as the query says
  std::vector<std::string> forbid;     // states, as the schema spells them
  std::vector<std::string> tricks;     // of level::trickOptions()
  std::string directions;              // as the schema spells them; empty: as the query says
  int32_t minJumps = -1, maxJumps = -1;
  float timeLimit = 0;  // seconds
  float maxDamage = -1;
};

// Returns true if the level has a part that it ends on: the goal of a query without one.
bool hasEnd(schema::Level::Reader level);
// Returns the error for a query without a goal in a level without an end. It names the first option
// that asks the query. `queries`: number of queries that the stream has for the level.
Error lacksGoal(schema::Level::Reader level, const QuickQuery& quick, uint64_t queries);

// Returns a query record with the id `id`. The default start is the level's first spawn. The
// default goal is its goal part, or else its last checkpoint. Error: a selector matches no part or
// several, or the level lacks a spawn or goal. The error's path is the option.
Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id);

// Returns a query record of places alone: `visits` to pass, `avoid` not to pass. Errors are as
// above, of the options --pass and --not-pass.
Result<io::Record> buildPlaces(schema::Level::Reader level, const std::vector<std::string>& pass,
                               const std::vector<std::string>& notPass);

// Returns the query with what `quick` asks for in place of its own. Errors are as above.
Result<io::Record> changeQuery(schema::Level::Reader level, const QuickQuery& quick,
                               const io::Record& query);

}  // namespace obby::solve
