// Regions of a query that name parts: the tools fill in the boxes before anything else reads the
// query, so that nothing else needs to know names.
#pragma once

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Does any region of the query name a part?
bool namesParts(schema::Query::Reader query);

// Gives every region of the query with a `part` its box, its name and its partIndex; an entry of a
// list whose #tag fits several parts becomes one entry for each. Resolving twice changes nothing.
// Error: a selector that fits no part, or several where one is meant; its path is the region's.
Status resolvePlaces(schema::Level::Reader level, schema::Query::Builder query);

}  // namespace obby::level
