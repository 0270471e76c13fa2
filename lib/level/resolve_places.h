// Fills in the boxes of a query's regions that name parts. The tools do this before anything else
// reads the query, so that no other code needs to know names.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns true if any region of the query names a part.
bool namesParts(schema::Query::Reader query);

// Max entries that stand for parts in all lists of a query together, after each #tag or name is
// expanded to all its parts. Each entry is tested after every tick.
constexpr size_t kMaxPlaces = 100000;

// Sets the box, name and partIndex of every region of the query that has a `part`. A list entry
// whose #tag fits several parts becomes one entry for each; in the avoid list a name does, too. A
// goal's #tag becomes the first of its parts, and the others join the goals. Resolving twice
// changes nothing. A selector that fits no part, or several where one is needed, is an error with
// the region's path. More than kMaxPlaces places are an error.
Status resolvePlaces(schema::Level::Reader level, schema::Query::Builder query);

}  // namespace obby::level
