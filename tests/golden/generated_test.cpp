// Generated levels are the same bytes on every machine and with every compiler.
// tests/golden/generated.tsv holds hashes of each style's first levels and of their twins. After a
// deliberate change of levels, run:
//   OBBY_WRITE_GOLDEN=1 test_golden --gtest_filter='Generated*' && git diff tests/golden
#include <fmt/format.h>

#include "base/hash.h"
#include "gen/made.h"
#include "golden/committed.h"

namespace obby::test {
namespace {

constexpr const char* kGeneratedFile = OBBY_SOURCE_DIR "/tests/golden/generated.tsv";

TEST(GeneratedLevels, AreTheCommittedOnes) {
  std::string now;
  for (const gen::Style& s : gen::styles()) {
    gen::Recipe recipe;
    recipe.styles = {{s.name, 1}};
    recipe.difficulty = {0, 1};
    recipe.waypoints = recipe.jumpLimits = recipe.timeLimits = 0.5f;
    const gen::Generator generator = generatorOf(recipe), twins = generatorOf(recipe, true);
    const auto hashOf = [](const gen::Generator& from) {
      uint64_t hash = 0;
      for (uint64_t i = 0; i < 32; ++i) {
        const std::string bytes = bytesOf(makeRecords(from, 1, i));
        hash = hashBytes(bytes.data(), bytes.size(), hash);
      }
      return hash;
    };
    now += fmt::format("{}\t{:016x}\t{:016x}\n", s.name, hashOf(generator), hashOf(twins));
  }
  golden::expectCommitted(kGeneratedFile, now);
}

}  // namespace
}  // namespace obby::test
