// Makes the levels that the command line requests.
#pragma once

#include "cli/context.h"
#include "train/run/streamed_levels.h"

namespace obby::tools {

// Returns true if levels are generated and no stream is read.
bool makesLevels(const cli::Arguments& arguments);

// Returns generated levels or those of the stream, the same on every rank. `seed`: seed of the
// generated levels. `again`: a stream repeats at its end. `timeout` is for the stream and must
// outlive the levels.
Result<train::Levels> levelsOf(cli::Context& context, train::Ranks& ranks, uint64_t seed,
                               bool again, train::Timeout& timeout);

}  // namespace obby::tools
