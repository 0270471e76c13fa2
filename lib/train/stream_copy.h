// A stream of levels in memory, whole: for ranks that share what only one of them can read.
#pragma once

#include <cstdint>
#include <string>

#include "io/pipeline.h"
#include "train/wait_limit.h"

namespace obby::train {

// Bytes of such a copy, at most; each rank holds it a few times.
inline constexpr uint64_t kMostCopied = uint64_t(4) << 30;

// Levels and queries of the whole stream, and the physics parameters before them, as Cap'n Proto
// messages; what came so far where `waiting` ends it. Errors: those of the stream; more than `most`
// bytes, as of one without end.
Result<std::string> copyOfStream(io::SourceOptions options, WaitLimit& waiting,
                                 uint64_t most = kMostCopied);

}  // namespace obby::train
