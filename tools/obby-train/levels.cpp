#include "levels.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "io/read_file.h"
#include "shared/generated_levels.h"
#include "shared/recipe_options.h"

namespace obby::tools {

namespace {

// What makes the levels: options as they were typed, the recipe by what is in it.
Result<std::vector<train::Setting>> settingsOf(const cli::Arguments& a) {
  std::vector<train::Setting> out = {{"levels", "generated"}};
  for (const char* name : {"style", "difficulty", "recipe"}) {
    std::string value = a.has(name) ? "" : "absent";
    if (a.has(name) && name == std::string("recipe")) {
      OBBY_ASSIGN(const std::string text, io::readFile(a.text(name)));
      value = fmt::format("a file of hash {:016x}", hashBytes(text.data(), text.size()));
    } else if (a.has(name)) {
      value = fmt::format("{}", fmt::join(a.values.at(name).texts, " "));
    }
    out.push_back({name, value});
  }
  return out;
}

}  // namespace

bool makesLevels(const cli::Arguments& a) {
  return a.flag("generate") || a.has("style") || a.has("difficulty") || a.has("recipe");
}

Result<Levels> levelsOf(cli::Context& context, train::Ranks& ranks, uint64_t seed, bool again) {
  const cli::Arguments& a = context.arguments();
  if (!makesLevels(a)) return streamedLevels(context, ranks, again);
  OBBY_ASSIGN(gen::Recipe recipe, recipeOf(a));
  if (!a.has("difficulty") && !a.has("recipe")) recipe.difficulty = {0, 1};
  Levels levels;
  OBBY_ASSIGN(levels.source, generatedLevels(recipe, seed));
  OBBY_ASSIGN(levels.settings, settingsOf(a));
  return levels;
}

}  // namespace obby::tools
