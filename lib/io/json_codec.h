// JSON lines to records and back, by reflection over the schema: no code here knows any single
// record. The rules are at the top of schema/obby.capnp. On reading, fields that the schema does
// not have are passed over (later minor versions add some), null means absent, a field given twice
// is refused, a 64-bit integer may also be a number up to 2^53, and nesting is at most 64 deep.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::io {

// One line without its newline. Errors carry the path in the record and what was expected.
Result<RecordBuilder> recordFromJson(std::string_view line);

// Likewise; nothing for a kind that the schema does not have. `misspelt` gets the first few fields
// that were ignored although a field of the schema has nearly the same name, and a kind that is
// nearly one of the schema is an error. Null: the record may be of a later schema, where both have
// a meaning.
Result<std::optional<RecordBuilder>> recordFromJsonIfKnown(std::string_view line,
                                                           std::vector<Error>* misspelt = nullptr);

// True if a record that could not be read ends in the middle of a value: it is cut off, or
// continues on the next line.
bool endsInside(const Error& error);

// One line without its newline; shortest numbers that read back to the same bits, defaults left
// out. Error: a number that is not finite or out of range, text that is not UTF-8, an unknown kind.
Result<std::string> recordToJson(schema::Record::Reader record);

}  // namespace obby::io
