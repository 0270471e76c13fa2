// Physics parameters of a record, checked against the schema.
#pragma once

#include <string>

#include "base/result.h"
#include "level/params.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Physics parameters of a record, checked against the schema's ranges, with the derived fields
// filled in.
Result<Params> compileParams(schema::PhysicsParams::Reader record);

// What the schema allows a parameter to be, by its name there.
schema::Interval::Reader paramRange(const std::string& name);

}  // namespace obby::level
