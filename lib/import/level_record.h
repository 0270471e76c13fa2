// From the importer's draft to the records of the stream.
#pragma once

#include "import/draft.h"
#include "import/tree.h"
#include "io/record.h"

namespace obby::importer {

// The level record. Numbers are brought into the schema's ranges; texts that are no UTF-8 get
// replacement characters.
io::RecordBuilder levelRecord(const LevelDraft& level, const Tree& tree);

// Bytes of any encoding as valid UTF-8: bad bytes and zeros become U+FFFD.
std::string validUtf8(std::string_view text);

}  // namespace obby::importer
