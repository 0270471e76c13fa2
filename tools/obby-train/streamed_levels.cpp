#include <fmt/format.h>

#include <map>

#include "base/hash.h"
#include "io/record.h"
#include "levels.h"

namespace obby::tools {

namespace {

// Every query of a stream with its level, compiled when they are read: what is wrong with one is
// said at once.
class StreamedLevels : public train::LevelSource {
 public:
  explicit StreamedLevels(std::vector<std::shared_ptr<const train::TrainingLevel>> levels)
      : levels_(std::move(levels)) {}

  Result<std::shared_ptr<const train::TrainingLevel>> level(uint64_t index, float) const override {
    return levels_[index % levels_.size()];
  }

 private:
  std::vector<std::shared_ptr<const train::TrainingLevel>> levels_;
};

Error inRecord(Error error, const io::Record& record) {
  if (error.place.empty()) error.place = record.place();
  return error;
}

using Made = std::vector<std::shared_ptr<const train::TrainingLevel>>;

// What is of use goes to `copy`, too.
Result<Made> readLevels(io::RecordSource& source, io::StreamWriter& copy) {
  std::map<std::string, io::Record> levels;
  Made made;
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, source.next());
    if (!record) return made;
    if (!record->known()) continue;
    if (record->which() == io::Kind::LEVEL) {
      levels.insert_or_assign(record->reader().getLevel().getName(), *record);
      OBBY_RETURN_IF_ERROR(copy.write(record->reader()));
    }
    if (record->which() != io::Kind::QUERY) continue;
    const auto query = record->reader().getQuery();
    const auto level = levels.find(query.getLevel());
    if (level == levels.end()) {
      OBBY_RETURN_IF_ERROR(
          source.forgive(*record, makeError(std::string("there is no level '") +
                                            query.getLevel().cStr() + "' before this query")));
      continue;
    }
    auto one = train::TrainingLevel::make(level->second.reader().getLevel(), query, {});
    if (one) {
      made.push_back(*std::move(one));
      OBBY_RETURN_IF_ERROR(copy.write(record->reader()));
    } else {
      OBBY_RETURN_IF_ERROR(source.forgive(*record, inRecord(one.error(), *record)));
    }
  }
}

// Reads `options`; `copy` becomes the stream that gives the same levels.
Result<Made> readAll(io::SourceOptions options, std::string& copy) {
  io::RecordSource source(std::move(options));
  io::StreamWriter writer = io::StreamWriter::toBytes(io::Format::capnp, &copy);
  OBBY_ASSIGN(Made made, readLevels(source, writer));
  OBBY_RETURN_IF_ERROR(writer.close());
  if (made.empty()) {
    return makeError("no levels with queries to learn from",
                     "pipe obby-gen into obby-train, or let it make levels with --generate");
  }
  return made;
}

}  // namespace

// Standard input is the first rank's alone, and a file may be.
Result<Levels> streamedLevels(cli::Context& context, train::Ranks& ranks) {
  std::string copy, unused;
  OBBY_ASSIGN(Made made, ranks.agree(ranks.first() ? readAll(context.sourceOptions(), copy)
                                                   : Result<Made>(Made())));
  copy = ranks.share(std::move(copy));
  if (!ranks.first()) {
    io::SourceOptions options;
    options.open = [&](const std::string&) {
      return Result<io::StreamReader>(io::StreamReader::overBytes(copy, "the first rank's levels"));
    };
    OBBY_ASSIGN(made, readAll(std::move(options), unused));
  }
  const auto hash = hashBytes(copy.data(), copy.size());
  return Levels{std::make_unique<StreamedLevels>(std::move(made)),
                {{"levels", fmt::format("a stream of hash {:016x}", hash)}}};
}

}  // namespace obby::tools
