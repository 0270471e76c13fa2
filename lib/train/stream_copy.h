// A whole level stream in memory, for ranks when only one of them can read the stream.
#pragma once

#include <cstdint>
#include <string>

#include "io/pipeline.h"
#include "train/timeout.h"

namespace obby::train {

// Max bytes of a copy; each rank holds several.
inline constexpr uint64_t kMaxCopied = uint64_t(4) << 30;

struct StreamCopy {
  // Levels and queries, and the physics parameters before them, as Cap'n Proto messages.
  std::string records;
  io::SourceSummary summary;  // summary of all records that were read for the copy
};

// Copies the whole stream, or the records that arrived before `timeout` ended it. Errors: those of
// the stream; an interrupted end, unless `options` forgive it; more than `max` bytes, for example
// from an endless stream.
Result<StreamCopy> copyOfStream(io::SourceOptions options, Timeout& timeout,
                                uint64_t max = kMaxCopied);

}  // namespace obby::train
