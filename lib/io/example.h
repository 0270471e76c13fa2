// Examples of the schema's objects, for errors about values of another form. Private to lib/io.
#pragma once

#include <string>

#include "io/schema_plan.h"

namespace obby::io {

// Returns `{"damage":100}`: the fields with $example, or else the first field with its default.
// Every example can be read back.
std::string exampleOf(const StructPlan& plan);

}  // namespace obby::io
