// Turns the importer's draft into the records of the stream.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"
#include "io/record.h"

namespace obby::importer {

// Returns the level record. Numbers are clamped to the schema's ranges. Invalid UTF-8 gets
// replacement characters.
io::RecordBuilder levelRecord(const LevelDraft& level, const Tree& tree);

// Writes the numbers that the avatar decides.
void setAvatar(schema::PhysicsParams::Builder to, const Avatar& avatar);

// Returns bytes of any encoding as valid UTF-8. Bad bytes and zeros become U+FFFD.
std::string validUtf8(std::string_view text);

}  // namespace obby::importer
