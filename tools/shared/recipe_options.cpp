#include "shared/recipe_options.h"

#include <fmt/format.h>

#include <utility>

#include "cli/rows.h"
#include "gen/styles.h"
#include "io/read_file.h"
#include "io/text.h"

namespace obby::tools {

namespace {

using cli::OptionRow;
using cli::row;
using cli::ValueType;

OptionRow styleRow(const char* group) {
  OptionRow r = row("style", ValueType::text, "NAME", "",
                    "make only levels of this style; if repeated, equal numbers of each; obby-gen "
                    "--list lists the styles",
                    group);
  r.repeatable = true;
  return r;
}

OptionRow difficultyRow(const char* group, const char* defaultText) {
  OptionRow r = row("difficulty", ValueType::text, "D", "", "", group);
  r.help = fmt::format(
      "trivial, easy, medium, hard, limit or a number from 0 to 1; D..D is a range to draw from "
      "[default: {}]",
      defaultText);
  return r;
}

Result<gen::Range> rangeOf(const std::string& text) {
  const size_t dots = text.find("..");
  const auto one = [](const std::string& word) {
    auto value = gen::parseDifficulty(word);
    if (!value) value.error().path = "--difficulty";
    return value;
  };
  OBBY_ASSIGN(const float lo, one(text.substr(0, dots)));
  if (dots == std::string::npos) return gen::Range{lo, lo};
  OBBY_ASSIGN(const float hi, one(text.substr(dots + 2)));
  if (lo > hi) {
    std::string wrong = "expected the easier end first, found " + io::quoted(text);
    return Error{{}, {}, "--difficulty", std::move(wrong), {}};
  }
  return gen::Range{lo, hi};
}

Result<gen::Recipe> recipeIn(const std::string& text, const std::string& path) {
  auto recipe = gen::Recipe::fromJson(text);
  if (!recipe) recipe.error().input = path == "-" ? "stdin" : path;
  return recipe;
}

}  // namespace

std::vector<OptionRow> recipeRows(const char* group, const char* defaultDifficulty) {
  return {
      styleRow(group),
      difficultyRow(group, defaultDifficulty),
      row("recipe", ValueType::file, "FILE", "",
          "read styles, weights, lengths, limits and physics from a JSON file (docs/generator.md)",
          group),
  };
}

Result<std::string> recipeText(const cli::Arguments& a) {
  if (!a.has("recipe")) return std::string();
  return io::readFile(a.text("recipe"));
}

Result<gen::Recipe> recipeOf(const cli::Arguments& a) {
  OBBY_ASSIGN(const std::string text, recipeText(a));
  return recipeOf(a, text);
}

Result<gen::Recipe> recipeOf(const cli::Arguments& a, const std::string& text) {
  gen::Recipe recipe;
  if (a.has("recipe")) {
    OBBY_ASSIGN(recipe, recipeIn(text, a.text("recipe")));
  }
  if (a.has("style")) recipe.styles.clear();
  for (const std::string& name : a.list("style")) {
    OBBY_RETURN_IF_ERROR(gen::styleNamed(name, "--style"));
    recipe.styles.push_back({name, 1});
  }
  if (a.has("difficulty")) {
    OBBY_ASSIGN(recipe.difficulty, rangeOf(a.text("difficulty")));
  }
  return recipe;
}

}  // namespace obby::tools
