// Training levels from input streams, the same on every rank.
#pragma once

#include <memory>
#include <vector>

#include "train/level_stream.h"
#include "train/ranks.h"
#include "train/settings.h"
#include "train/timeout.h"

namespace obby::train {

struct Levels {
  std::unique_ptr<LevelSource> source;
  std::vector<Setting> settings;        // identify the levels
  const LevelStream* stream = nullptr;  // the source if it is a stream

  // Returns the counts of the records that were read so far.
  io::SourceSummary summary() const {
    return stream != nullptr ? stream->summary() : io::SourceSummary();
  }
};

// Returns the queries of `options` with their levels. The first of several ranks reads all of them
// before training. `again`: the stream repeats at its end. `timeout` must outlive the levels.
// Errors: lateStream(), and those of the stream.
Result<Levels> streamedLevels(io::SourceOptions options, Ranks& ranks, bool again,
                              Timeout& timeout);

// Returns the error of training that could not start, because too few levels arrived in time.
Error lateStream();

}  // namespace obby::train
