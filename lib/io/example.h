// How an object of the schema may be written, for errors where something else was found. Private to
// lib/io.
#pragma once

#include <string>

#include "io/schema_plan.h"

namespace obby::io {

// `{"damage":100}`: the fields that carry $example, or else the first one with its default. Every
// example can be read back.
std::string exampleOf(const StructPlan& plan);

}  // namespace obby::io
