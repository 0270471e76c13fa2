#include "levels.h"
#include "train/level_stream.h"
#include "train/stream_copy.h"

namespace obby::tools {

namespace {

// On the first rank.
Result<std::string> copyOf(io::SourceOptions options, train::WaitLimit& waiting) {
  OBBY_ASSIGN(std::string copy, train::copyOfStream(std::move(options), waiting));
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
    OBBY_ASSIGN(std::string copy, ranks.agree(ranks.first() ? copyOf(options, waiting)
                                                            : Result<std::string>(std::string())));
    copy = ranks.share(std::move(copy));
    options.inputs = {"the first rank's levels"};
    options.stop = nullptr;  // they are here already; all ranks end after the same iteration
    settings.wait = nullptr;
    options.open = [copy](const std::string& name) {
      return Result<io::StreamReader>(io::StreamReader::overBytes(copy, name));
    };
  }
  settings.again = again;
  if (!again) settings.choices = 1;  // each is to be played
  return Levels{std::make_unique<train::LevelStream>(std::move(options), settings),
                {{"levels", "of a stream"}}};
}

Error lateStream() {
  return makeError("too few levels came from the stream within --time-limit: nothing was learned",
                   "see what keeps the stream, or give it more time");
}

}  // namespace obby::tools
