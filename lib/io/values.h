// Defines which fields count as set, and which values no record may hold. Private to lib/io.
#pragma once

#include <capnp/dynamic.h>

#include <optional>
#include <string>

#include "io/schema_plan.h"

namespace obby::io {

// Returns true if a field says more than its absence: numbers, names and tuples that differ from
// their default, texts and lists that are not empty, and structs that are present (a `kill` is one
// even if all its fields are defaults).
bool isSet(const FieldPlan& field, capnp::DynamicStruct::Reader in);

// Returns nothing if the scalar or text is valid there, otherwise what is wrong with it. Structs
// and lists are always valid.
std::optional<std::string> refuseScalar(const TypePlan& type,
                                        const capnp::DynamicValue::Reader& value);

}  // namespace obby::io
