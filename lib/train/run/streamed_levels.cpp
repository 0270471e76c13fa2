#include "train/run/streamed_levels.h"

#include "train/stream_copy.h"

namespace obby::train {

namespace {

// Copies the stream within the time limit. Only the first rank calls it.
Result<StreamCopy> timedCopy(io::SourceOptions options, Timeout& timeout) {
  OBBY_ASSIGN(StreamCopy copy, copyOfStream(std::move(options), timeout));
  if (timeout.expired()) return lateStream();
  if (timeout.stop()) return makeError(kInterrupted);
  return copy;
}

}  // namespace

// Only the first rank has standard input, and it may be the only one that has the files.
Result<Levels> streamedLevels(io::SourceOptions options, Ranks& ranks, bool again,
                              Timeout& timeout) {
  options.stop = &timeout.stop();
  LevelStreamSettings settings;
  settings.timeout = &timeout;
  if (ranks.count() > 1) {
    OBBY_ASSIGN(StreamCopy copy, ranks.agree(ranks.first() ? timedCopy(options, timeout)
                                                           : Result<StreamCopy>(StreamCopy())));
    settings.before = copy.summary;
    options.inputs = {"the first rank's levels"};
    options.stop = nullptr;  // all records are in memory; all ranks end after the same iteration
    if (!ranks.first()) options.report = nullptr;  // all ranks read the same records
    settings.timeout = nullptr;
    options.open = [records = ranks.share(std::move(copy.records))](const std::string& name) {
      return Result<io::StreamReader>(io::StreamReader::overBytes(records, name));
    };
  }
  settings.again = again;
  if (!again) settings.choices = 1;  // every query is played
  auto stream = std::make_unique<LevelStream>(std::move(options), settings);
  const LevelStream* const same = stream.get();
  return Levels{std::move(stream), {{"levels", "from a stream"}}, same};
}

Error lateStream() {
  return makeError("too few levels arrived within --time-limit, so nothing was trained",
                   "check the program that writes the levels, or raise --time-limit");
}

}  // namespace obby::train
