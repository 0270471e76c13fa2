#include "shared/generated_levels.h"

#include "gen/styles.h"

#include <algorithm>

#include "gen/generator.h"
#include "io/record.h"

namespace obby::tools {

namespace {

// Has a generator for each step of the difficulty.
class GeneratedLevels : public train::LevelSource {
 public:
  static constexpr int kSteps = 20;

  GeneratedLevels(std::vector<gen::Generator> generators, uint64_t seed)
      : generators_(std::move(generators)), seed_(seed) {}

  Result<std::shared_ptr<const train::TrainingLevel>> level(uint64_t index,
                                                            float hardest) const override {
    const int step = std::clamp(int(hardest * float(kSteps) + 0.5f), 0, kSteps);
    const gen::Generator& generator = generators_[size_t(step)];
    const gen::Generated made = generator.generate(seed_, index);
    io::RecordBuilder level(4096), query;
    generator.writeLevel(made, level.root().initLevel());
    gen::Generator::writeQuery(made, query.root().initQuery());
    return train::TrainingLevel::make(level.reader().getLevel(), query.reader().getQuery());
  }

 private:
  std::vector<gen::Generator> generators_;  // (kSteps + 1)
  uint64_t seed_;
};

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

uint16_t styleNumberOf(const train::TrainingLevel& level) {
  const gen::Style* const style = gen::styleOfLevel(level.name());
  return style == nullptr ? uint16_t(0) : uint16_t(style - gen::styles().data() + 1);
}

std::vector<std::string> styleNames() {
  std::vector<std::string> names = {""};
  for (const gen::Style& style : gen::styles()) names.emplace_back(style.name);
  return names;
}

}  // namespace obby::tools
