// The writing half of the JSON codec. Private to lib/io.
#pragma once

#include <string>

#include "base/result.h"
#include "io/json_writer.h"
#include "io/path.h"
#include "io/schema_plan.h"

namespace obby::io {

// Writes records as JSON. Every member function returns false after an error, which `error` then
// holds: a number that is not finite or out of range, or text that is not UTF-8.
class JsonEncoder {
 public:
  // Appends `{"type":"level",...}` for a record of a known kind.
  bool record(capnp::DynamicStruct::Reader record);

  bool value(const TypePlan& type, const capnp::DynamicValue::Reader& in, const Path& path);

  JsonWriter out;
  Error error;

 private:
  bool fields(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path);
  bool object(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path);
  bool tuple(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path);
  bool list(const TypePlan& element, capnp::DynamicList::Reader in, const Path& path);
  bool fail(const Path& path, std::string message);
};

}  // namespace obby::io
