// Physics parameters of a record, checked against the schema.
#pragma once

#include <string>

#include "base/result.h"
#include "level/params.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns the physics parameters of a record with the derived fields filled in. A value outside the
// schema's range is an error.
Result<Params> compileParams(schema::PhysicsParams::Reader record);

// Returns the schema's range of a parameter, which must exist.
schema::Interval::Reader paramRange(const std::string& name);

}  // namespace obby::level
