// JSON lines to records and back, by reflection over the schema: no code here knows any single
// record. The rules are at the top of schema/obby.capnp.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "io/record.h"

namespace obby::io {

// One line without its newline. Errors carry the path in the record and what was expected.
Result<RecordBuilder> recordFromJson(std::string_view line);

// One line without its newline; shortest numbers that read back to the same bits, defaults left
// out.
std::string recordToJson(schema::Record::Reader record);

}  // namespace obby::io
