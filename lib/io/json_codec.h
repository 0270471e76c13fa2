// Converts JSON lines to records and back, by reflection over the schema: no code here depends on a
// single record. The rules are at the top of schema/obby.capnp. Reading ignores fields that the
// schema does not have (later minor versions add some). null means absent, a field given twice is
// an error, a 64-bit integer may also be a number up to 2^53, and nesting is at most 64 deep.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/record.h"

namespace obby::io {

// Reads one line without its newline. Errors have the path in the record and what was expected.
Result<RecordBuilder> recordFromJson(std::string_view line);

// Reads a line like recordFromJson(), but returns nothing for a kind that the schema does not have.
// `misspelt` receives the first few ignored fields with a name close to a field of the schema; a
// kind close to one of the schema is an error. If `misspelt` is null, both are allowed: in records
// of a later schema they may have a meaning.
Result<std::optional<RecordBuilder>> recordFromJsonIfKnown(std::string_view line,
                                                           std::vector<Error>* misspelt = nullptr);

// Returns true if a record could not be read because it ends in the middle of a value: it is cut
// off, or continues on the next line.
bool endsInside(const Error& error);

// Returns one line without its newline. Numbers are the shortest that read back to the same bits,
// and defaults are left out. Errors are a number that is not finite or out of range, text that is
// not UTF-8, and an unknown kind.
Result<std::string> recordToJson(schema::Record::Reader record);

}  // namespace obby::io
