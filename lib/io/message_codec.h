// Cap'n Proto messages in a stream of bytes, unpacked or packed. Claimed sizes are checked against
// a cap before anything is read for them. Private to lib/io.
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

// One message: its words with the segment table before them, and the bytes it came as.
struct RawMessage {
  std::vector<uint64_t> words;
  std::string bytes;
};

// The next message; nothing at the end of the input. Errors have no input and place.
Result<std::optional<RawMessage>> readMessage(ByteSource& source, bool packed);

// The record in a message, checked and copied; nothing for a kind that the schema does not have.
Result<std::optional<RecordBuilder>> recordFromWords(const std::vector<uint64_t>& words);

// The normal form of a record as one message.
Result<std::string> messageFromRecord(schema::Record::Reader record, bool packed);

// Whether `begin` (8 bytes or more, or the whole input) can begin a stream of messages.
enum class Looks { unpacked, packed, neither };
Looks looksLikeMessage(std::string_view begin);

}  // namespace obby::io
