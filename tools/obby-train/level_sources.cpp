#include "level_sources.h"

#include <algorithm>
#include <map>

#include "gen/generator.h"
#include "io/record.h"

namespace obby::tools {

namespace {

using Levels = Result<std::shared_ptr<const train::TrainingLevel>>;

// A generator for each step of the difficulty.
class GeneratedLevels : public train::LevelSource {
 public:
  static constexpr int kSteps = 20;

  GeneratedLevels(std::vector<gen::Generator> generators, uint64_t seed)
      : generators_(std::move(generators)), seed_(seed) {}

  Levels level(uint64_t index, float hardest) const override {
    const int step = std::clamp(int(hardest * float(kSteps) + 0.5f), 0, kSteps);
    const gen::Generator& generator = generators_[size_t(step)];
    const gen::Generated made = generator.generate(seed_, index);
    io::RecordBuilder level(4096), query;
    generator.writeLevel(made, level.root().initLevel());
    gen::Generator::writeQuery(made, query.root().initQuery());
    std::vector<Vec3> way;
    for (const gen::Stop& stop : made.sketch.stops()) way.push_back(stop.feet);
    return train::TrainingLevel::make(level.reader().getLevel(), query.reader().getQuery(),
                                      std::move(way));
  }

 private:
  std::vector<gen::Generator> generators_;  // (kSteps + 1)
  uint64_t seed_;
};

// Every query of a stream with its level, compiled when they are read: what is wrong with one is
// said at once.
class StreamedLevels : public train::LevelSource {
 public:
  explicit StreamedLevels(std::vector<std::shared_ptr<const train::TrainingLevel>> levels)
      : levels_(std::move(levels)) {}

  Levels level(uint64_t index, float) const override { return levels_[index % levels_.size()]; }

 private:
  std::vector<std::shared_ptr<const train::TrainingLevel>> levels_;
};

Error inRecord(Error error, const io::Record& record) {
  if (error.place.empty()) error.place = record.place();
  return error;
}

}  // namespace

Result<std::unique_ptr<train::LevelSource>> generatedLevels(const gen::Recipe& recipe,
                                                            uint64_t seed) {
  std::vector<gen::Generator> generators;
  for (int step = 0; step <= GeneratedLevels::kSteps; ++step) {
    gen::Recipe r = recipe;
    const float share = float(step) / GeneratedLevels::kSteps;
    r.difficulty.hi = recipe.difficulty.lo + share * (recipe.difficulty.hi - recipe.difficulty.lo);
    OBBY_ASSIGN(gen::Generator generator, gen::Generator::make(r, false));
    generators.push_back(std::move(generator));
  }
  return std::unique_ptr<train::LevelSource>(
      std::make_unique<GeneratedLevels>(std::move(generators), seed));
}

Result<std::unique_ptr<train::LevelSource>> streamedLevels(cli::Context& context) {
  io::RecordSource source(context.sourceOptions());
  std::map<std::string, io::Record> levels;
  std::vector<std::shared_ptr<const train::TrainingLevel>> made;
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, source.next());
    if (!record) break;
    if (!record->known()) continue;
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
  return std::unique_ptr<train::LevelSource>(std::make_unique<StreamedLevels>(std::move(made)));
}

}  // namespace obby::tools
