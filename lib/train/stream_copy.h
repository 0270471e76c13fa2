// A stream of levels in memory, whole: for ranks that share what only one of them can read.
#pragma once

#include <cstdint>
#include <string>

#include "io/pipeline.h"
#include "train/wait_limit.h"

namespace obby::train {

// Bytes of such a copy, at most; each rank holds it a few times.
inline constexpr uint64_t kMostCopied = uint64_t(4) << 30;

struct StreamCopy {
  // Levels and queries, and the physics parameters before them, as Cap'n Proto messages.
  std::string records;
  io::SourceSummary summary;  // of all that was read for it
};

// Of the whole stream; of what came so far where `waiting` ends it. Errors: those of the stream; an
// end that says it was interrupted, unless `options` forgive that; more than `most` bytes, as of
// one without end.
Result<StreamCopy> copyOfStream(io::SourceOptions options, WaitLimit& waiting,
                                uint64_t most = kMostCopied);

}  // namespace obby::train
