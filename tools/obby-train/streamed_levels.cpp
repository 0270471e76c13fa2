#include "levels.h"
#include "train/level_stream.h"
#include "train/stream_copy.h"

namespace obby::tools {

namespace {

// On the first rank.
Result<train::StreamCopy> copyOf(io::SourceOptions options, train::WaitLimit& waiting) {
  OBBY_ASSIGN(train::StreamCopy copy, train::copyOfStream(std::move(options), waiting));
  if (waiting.isUp()) return lateStream();
  if (waiting.stop()) return makeError(train::kInterrupted);
  return copy;
}

}  // namespace

// Standard input is the first rank's alone, and a file may be: it reads for all of them.
Result<Levels> streamedLevels(cli::Context& context, train::Ranks& ranks, bool again,
                              train::WaitLimit& waiting) {
  io::SourceOptions options = context.sourceOptions();
  options.stop = &waiting.stop();
  train::LevelStreamSettings settings;
  settings.wait = &waiting;
  if (ranks.count() > 1) {
    OBBY_ASSIGN(train::StreamCopy copy,
                ranks.agree(ranks.first() ? copyOf(options, waiting)
                                          : Result<train::StreamCopy>(train::StreamCopy())));
    settings.before = copy.summary;
    options.inputs = {"the first rank's levels"};
    options.stop = nullptr;  // they are here already; all ranks end after the same iteration
    if (!ranks.first()) options.report = nullptr;  // all come to the same records
    settings.wait = nullptr;
    options.open = [records = ranks.share(std::move(copy.records))](const std::string& name) {
      return Result<io::StreamReader>(io::StreamReader::overBytes(records, name));
    };
  }
  settings.again = again;
  if (!again) settings.choices = 1;  // each is to be played
  auto stream = std::make_unique<train::LevelStream>(std::move(options), settings);
  const train::LevelStream* const same = stream.get();
  return Levels{std::move(stream), {{"levels", "from a stream"}}, same};
}

Error lateStream() {
  return makeError("too few levels arrived within --time-limit: nothing was trained",
                   "check what delays the stream, or raise --time-limit");
}

}  // namespace obby::tools
