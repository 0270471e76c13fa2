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

}  // namespace

Result<Levels> streamedLevels(cli::Context& context) {
  io::RecordSource source(context.sourceOptions());
  std::string bytes;  // of the levels and queries, whatever the stream's encoding
  io::StreamWriter writer = io::StreamWriter::toBytes(io::Format::capnp, &bytes);
  std::map<std::string, io::Record> levels;
  std::vector<std::shared_ptr<const train::TrainingLevel>> made;
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, source.next());
    if (!record) break;
    if (!record->known()) continue;
    if (record->which() == io::Kind::LEVEL || record->which() == io::Kind::QUERY)
      OBBY_RETURN_IF_ERROR(writer.write(record->reader()));
    if (record->which() == io::Kind::LEVEL) {
      levels.insert_or_assign(record->reader().getLevel().getName(), *record);
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
    } else {
      OBBY_RETURN_IF_ERROR(source.forgive(*record, inRecord(one.error(), *record)));
    }
  }
  if (made.empty()) {
    return makeError("no levels with queries to learn from",
                     "pipe obby-gen into obby-train, or let it make levels with --generate");
  }
  OBBY_RETURN_IF_ERROR(writer.close());
  const auto hash = hashBytes(bytes.data(), bytes.size());
  return Levels{std::make_unique<StreamedLevels>(std::move(made)),
                {{"levels", fmt::format("a stream of hash {:016x}", hash)}}};
}

}  // namespace obby::tools
