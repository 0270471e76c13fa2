// Recipes of obby-gen. Any input results in an error, or in levels that compile.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "gen/generator.h"
#include "io/record.h"
#include "level/level.h"

namespace {

using namespace obby;

void check(const gen::Generator& generator) {
  const gen::Generated made = generator.generate(1, 0);
  io::RecordBuilder level, query;
  generator.writeLevel(made, level.root().initLevel());
  gen::Generator::writeQuery(made, query.root().initQuery());
  const auto compiled = level::Level::compile(level.reader().getLevel());
  if (!compiled) std::abort();
  if (!level::Query::compile(query.reader().getQuery(), *compiled)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto recipe = obby::gen::Recipe::fromJson(text);
  if (!recipe) return 0;
  for (const bool unsolvable : {false, true}) {
    const auto generator = obby::gen::Generator::make(*recipe, unsolvable);
    if (generator) check(*generator);
  }
  return 0;
}
