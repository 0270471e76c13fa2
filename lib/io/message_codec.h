// Cap'n Proto messages in a stream of bytes, unpacked or packed. Claimed sizes are checked against
// a limit before anything is read for them. Private to lib/io.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/byte_source.h"
#include "io/record.h"

namespace obby::io {

// One message: its words with the segment table first, and the bytes that it was read from.
struct RawMessage {
  std::vector<uint64_t> words;
  std::string bytes;
};

// Returns the next message, or nothing at the end of the input. Errors lack the input and the
// place.
Result<std::optional<RawMessage>> readMessage(ByteSource& source, bool packed);

// Returns the record in a message, checked and copied, or nothing for a kind that the schema lacks.
Result<std::optional<RecordBuilder>> recordFromWords(const std::vector<uint64_t>& words);

// Returns the normal form of a record as one message.
Result<std::string> messageFromRecord(schema::Record::Reader record, bool packed);

// The encoding of which `begin` (at least 8 bytes, or the whole input) can be the start.
enum class Looks { unpacked, packed, neither };
Looks looksLikeMessage(std::string_view begin);

}  // namespace obby::io
