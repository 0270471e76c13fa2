// Some sentences for people: what was found, or how the attempts failed.
#pragma once

#include <string>

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/search/outcome.h"

namespace obby::solve {

// Says nothing that depends on the clock. `levelRecord`: for names, and what the importer left out.
std::string reasonFor(const SearchOutcome& outcome, const level::Level& level,
                      schema::Level::Reader levelRecord, schema::Query::Reader query);

}  // namespace obby::solve
