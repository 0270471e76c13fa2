#include "io/record.h"
#include "levels.h"
#include "train/level_stream.h"

namespace obby::tools {

namespace {

// Levels and queries of the whole stream.
Result<std::string> copyOf(io::SourceOptions options) {
  const std::atomic<bool>* const stop = options.stop;
  std::string copy;
  io::RecordSource source(std::move(options));
  io::StreamWriter writer = io::StreamWriter::toBytes(io::Format::capnp, &copy);
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, source.next());
    if (!record) break;
    if (!record->known()) continue;
    if (record->which() != io::Kind::LEVEL && record->which() != io::Kind::QUERY) continue;
    OBBY_RETURN_IF_ERROR(writer.write(record->reader()));
  }
  if (stop != nullptr && *stop) return makeError(train::kInterrupted);
  OBBY_RETURN_IF_ERROR(writer.close());
  return copy;
}

}  // namespace

// Standard input is the first rank's alone, and a file may be: it reads for all of them.
Result<Levels> streamedLevels(cli::Context& context, train::Ranks& ranks, bool again) {
  io::SourceOptions options = context.sourceOptions();
  if (ranks.count() > 1) {
    OBBY_ASSIGN(std::string copy,
                ranks.agree(ranks.first() ? copyOf(options) : Result<std::string>(std::string())));
    copy = ranks.share(std::move(copy));
    options.inputs = {"the first rank's levels"};
    options.stop = nullptr;  // they are here already; all ranks end after the same iteration
    options.open = [copy](const std::string& name) {
      return Result<io::StreamReader>(io::StreamReader::overBytes(copy, name));
    };
  }
  train::LevelStreamSettings settings;
  settings.again = again;
  if (!again) settings.choices = 1;  // each is to be played
  return Levels{std::make_unique<train::LevelStream>(std::move(options), settings),
                {{"levels", "of a stream"}}};
}

}  // namespace obby::tools
