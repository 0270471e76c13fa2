// Regions of a query that name parts: the tools fill in the boxes before anything else reads the
// query, so that nothing else needs to know names.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Does any region of the query name a part?
bool namesParts(schema::Query::Reader query);

// Most entries of a query's lists together that stand for parts, after each #tag or name has become
// all its parts. Each is looked at after every tick.
constexpr size_t kMaxPlaces = 100000;

// Gives every region of the query with a `part` its box, its name and its partIndex; an entry of a
// list whose #tag fits several parts becomes one entry for each, and in the avoid list one whose
// name does; a goal's #tag becomes the first of its parts, with the others among the goals.
// Resolving twice changes nothing. Errors: a selector that fits no part, or several where one is
// meant; its path is the region's. More than kMaxPlaces places.
Status resolvePlaces(schema::Level::Reader level, schema::Query::Builder query);

}  // namespace obby::level
