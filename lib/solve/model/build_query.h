// Query records made from the command line, or from what the level says about itself.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::solve {

// A query in places: selectors of parts (level/select_parts.h), boxes, or touch:SELECTOR where the
// part itself has to be touched. What is empty or negative is not asked for.
struct QuickQuery {
  std::string start;
  std::vector<std::string> goals;      // any of them
  std::vector<std::string> waypoints;  // in order
  std::vector<std::string> visits;     // in any order; a #tag stands for all its parts
  std::vector<std::string> avoid;      // any name stands for all parts that it fits
  std::string arrive;                  // as the schema spells it; empty: as the query says
  std::vector<std::string> forbid;     // states, as the schema spells them
  std::vector<std::string> tricks;     // of level::trickOptions()
  std::string directions;              // as the schema spells them; empty: as the query says
  int32_t minJumps = -1, maxJumps = -1;
  float timeLimit = 0;  // seconds
  float maxDamage = -1;
};

// Has the level a part that it ends on, which a query without a goal asks for?
bool hasEnd(schema::Level::Reader level);
// Error for a question without a goal of a level without an end. Names the first option that asks
// it. `queries`: how many the stream has for the level.
Error lacksGoal(schema::Level::Reader level, const QuickQuery& quick, uint64_t queries);

// The query record; its id is `id`. Without a start the level's first spawn, without a goal its
// goal part, else its last checkpoint. Error: a selector that names no part or several, a level
// without a spawn or goal; its path is the option.
Result<io::Record> buildQuery(schema::Level::Reader level, const QuickQuery& quick,
                              const std::string& id);

// A query record of places alone: `visits` to pass, `avoid` not to. Errors as above, of the options
// --pass and --not-pass.
Result<io::Record> buildPlaces(schema::Level::Reader level, const std::vector<std::string>& pass,
                               const std::vector<std::string>& notPass);

// The query of a stream with what `quick` asks for in place of its own. Errors as above.
Result<io::Record> changeQuery(schema::Level::Reader level, const QuickQuery& quick,
                               const io::Record& query);

}  // namespace obby::solve
