#include "levels.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "shared/generated_levels.h"
#include "shared/recipe_options.h"

namespace obby::tools {

namespace {

// The settings that identify generated levels: options as typed, and a hash of the recipe.
std::vector<train::Setting> settingsOf(const cli::Arguments& a, const std::string& recipe) {
  std::vector<train::Setting> out = {{"levels", "generated"}};
  for (const char* name : {"style", "difficulty", "recipe"}) {
    std::string value = a.has(name) ? "" : "absent";
    if (a.has(name) && name == std::string("recipe")) {
      value = fmt::format("a file of hash {:016x}", hashBytes(recipe.data(), recipe.size()));
    } else if (a.has(name)) {
      value = fmt::format("{}", fmt::join(a.values.at(name).texts, " "));
    }
    out.push_back({name, value});
  }
  return out;
}

// The recipe may be a pipe, which only one rank can read, and only once.
Result<std::string> sharedRecipe(const cli::Arguments& a, train::Ranks& ranks) {
  OBBY_ASSIGN(std::string text,
              ranks.agree(ranks.first() ? recipeText(a) : Result<std::string>(std::string())));
  return ranks.share(std::move(text));
}

}  // namespace

bool makesLevels(const cli::Arguments& a) {
  return a.flag("generate") || a.has("style") || a.has("difficulty") || a.has("recipe");
}

Result<train::Levels> levelsOf(cli::Context& context, train::Ranks& ranks, uint64_t seed,
                               bool again, train::Timeout& timeout) {
  const cli::Arguments& a = context.arguments();
  if (!makesLevels(a)) return train::streamedLevels(context.sourceOptions(), ranks, again, timeout);
  OBBY_ASSIGN(const std::string text, sharedRecipe(a, ranks));
  OBBY_ASSIGN(gen::Recipe recipe, recipeOf(a, text));
  if (!a.has("difficulty") && !a.has("recipe")) recipe.difficulty = {0, 1};
  train::Levels levels;
  OBBY_ASSIGN(levels.source, generatedLevels(recipe, seed));
  levels.settings = settingsOf(a, text);
  return levels;
}

}  // namespace obby::tools
