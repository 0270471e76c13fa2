// The levels that the command line asks for.
#pragma once

#include <memory>

#include "cli/context.h"
#include "train/level_stream.h"
#include "train/ranks.h"
#include "train/settings.h"
#include "train/training_level.h"
#include "train/wait_limit.h"

namespace obby::tools {

struct Levels {
  std::unique_ptr<train::LevelSource> source;
  std::vector<train::Setting> settings;        // tell these levels from others
  const train::LevelStream* stream = nullptr;  // the source where it is one

  // What came of the records that were read so far.
  io::SourceSummary summary() const {
    return stream != nullptr ? stream->summary() : io::SourceSummary();
  }
};

// Is no stream read, for the levels are made?
bool makesLevels(const cli::Arguments& arguments);

// Made anew, or those of the stream; `seed`: of those that are made; `again`: asked for more than a
// stream has it begins again; `waiting`: for the stream, must outlive them. The same on every rank.
Result<Levels> levelsOf(cli::Context& context, train::Ranks& ranks, uint64_t seed, bool again,
                        train::WaitLimit& waiting);

// The queries of the context's inputs with their levels; of several ranks the first reads all of
// them before anything is learned. Error: none; what lateStream() says.
Result<Levels> streamedLevels(cli::Context& context, train::Ranks& ranks, bool again,
                              train::WaitLimit& waiting);

// The error of learning that could not begin, for the stream sent too little in time.
Error lateStream();

}  // namespace obby::tools
