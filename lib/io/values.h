// What counts as set, and which values no record may hold. Private to lib/io.
#pragma once

#include <capnp/dynamic.h>

#include <optional>
#include <string>

#include "io/schema_plan.h"

namespace obby::io {

// Whether a field says more than its absence: numbers, names and tuples that differ from their
// default, texts and lists that are not empty, structs that are present (a `kill` is one even when
// all its fields are defaults).
bool isSet(const FieldPlan& field, capnp::DynamicStruct::Reader in);

// Nothing if the scalar or text may stand there; else what is wrong with it. Structs and lists
// pass.
std::optional<std::string> refuseScalar(const TypePlan& type,
                                        const capnp::DynamicValue::Reader& value);

}  // namespace obby::io
