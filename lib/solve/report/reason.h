// Composes sentences for people: the solution that was found, or how the attempts failed.
#pragma once

#include <string>

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/search/outcome.h"

namespace obby::solve {

// The text does not depend on the clock. `levelRecord` supplies names and the importer's losses.
std::string reasonFor(const SearchOutcome& outcome, const level::Level& level,
                      schema::Level::Reader levelRecord, schema::Query::Reader query);

}  // namespace obby::solve
