// The option table of obby-gen and what its options mean to lib/gen.
#include "options.h"

#include <fmt/format.h>

#include "gen/styles.h"
#include "io/read_file.h"
#include "io/text.h"

namespace obby::tools {

namespace {

using cli::OptionRow;
using cli::ValueType;

constexpr const char* kLevelGroup = "Levels";
constexpr const char* kCheckGroup = "Checking";

OptionRow row(const char* name, ValueType type, const char* value, const char* defaultText,
              const char* help, const char* group) {
  OptionRow r;
  r.name = name;
  r.type = type;
  r.value = value;
  r.defaultText = defaultText;
  r.help = help;
  r.group = group;
  return r;
}

OptionRow between(OptionRow r, double min, double max) {
  r.min = min;
  r.max = max;
  return r;
}

OptionRow styleRow() {
  OptionRow r = row("style", ValueType::text, "NAME", "",
                    "make levels of this style only; repeat: of these, alike in number; --list "
                    "names them",
                    kLevelGroup);
  r.repeatable = true;
  return r;
}

OptionRow formatRow() {
  OptionRow r = cli::commonRow(cli::Common::format);
  r.choices.push_back("rbxlx");
  r.help +=
      "; rbxlx, or a FILE that ends so: a place file for Studio with all levels, side by side";
  return r;
}

std::vector<OptionRow> levelRows() {
  return {
      between(row("count", ValueType::integer, "N", "1", "levels to write; 0: without end",
                  kLevelGroup),
              0, 9e15),
      between(row("first", ValueType::integer, "N", "0",
                  "begin with level N of the seed: level N is the same in every run that has it",
                  kLevelGroup),
              0, 4e18),
      styleRow(),
      row("difficulty", ValueType::text, "D", "",
          "trivial, easy, medium, hard, limit or a number from 0 to 1; D..D draws between two "
          "[default: easy..hard]",
          kLevelGroup),
      row("recipe", ValueType::file, "FILE", "",
          "styles with weights, lengths, limits and physics from a JSON file (docs/generator.md)",
          kLevelGroup),
      row("unsolvable", ValueType::flag, "", "",
          "write of each level the twin in which one crossing is beyond reach; its name says which",
          kLevelGroup),
      cli::commonRow(cli::Common::seed),
      row("list", ValueType::flag, "", "", "print the styles and exit", kLevelGroup),
  };
}

std::vector<OptionRow> checkRows() {
  return {
      row("check", ValueType::flag, "", "",
          "keep only levels that the solver solves, with --unsolvable only those shown to be "
          "unreachable; the answer follows the query",
          kCheckGroup),
      between(row("check-steps", ValueType::integer, "N", "1000000",
                  "simulated ticks that --check gives each level", kCheckGroup),
              1, 9e15),
  };
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
  return gen::Range{lo, hi};
}

Result<gen::Recipe> readRecipe(const std::string& path) {
  OBBY_ASSIGN(const std::string text, io::readFile(path));
  auto recipe = gen::Recipe::fromJson(text);
  if (!recipe) recipe.error().input = path == "-" ? "stdin" : path;
  return recipe;
}

Status checkStyle(const std::string& name) {
  if (gen::findStyle(name) != nullptr) return {};
  std::vector<std::string> names;
  for (const gen::Style& s : gen::styles()) names.push_back(s.name);
  const std::string near = io::nearest(name, names);
  return Error{{},
               {},
               "--style",
               "there is no style " + io::quoted(name),
               near.empty() ? "obby-gen --list names them" : "did you mean " + near + "?"};
}

}  // namespace

cli::ToolSpec genSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-gen";
  spec.summary = "make levels with queries, as many as are wanted";
  spec.takesInputs = false;
  spec.examples = {
      {"a hard course, solved and shown",
       "obby-gen --style course --difficulty hard --count 1 | obby-solve | obby-view -o "
       "course.html"},
      {"a thousand levels of all styles", "obby-gen --count 1000 --seed 7 -o levels.capnp"},
      {"jumps at the limit that the solver has solved",
       "obby-gen --style gaps --difficulty limit --check --count 3 > solved.jsonl"},
      {"their twins, each with a gap that nobody crosses",
       "obby-gen --style gaps --difficulty limit --unsolvable --check --count 3 > twins.jsonl"},
      {"a place file to open in Studio",
       "obby-gen --style course --difficulty easy -o course.rbxlx"},
  };
  spec.options = {cli::commonRow(cli::Common::output), formatRow(),
                  cli::commonRow(cli::Common::progress), cli::commonRow(cli::Common::threads)};
  for (const auto& rows : {levelRows(), checkRows()}) {
    spec.options.insert(spec.options.end(), rows.begin(), rows.end());
  }
  spec.notes =
      "What is written depends on --seed, --first, --count and the recipe only, never on --threads "
      "or the machine. Level N of a seed without and with --unsolvable are twins: alike but for "
      "one "
      "crossing.";
  return spec;
}

Result<gen::Recipe> recipeOf(const cli::Arguments& a) {
  gen::Recipe recipe;
  if (a.has("recipe")) {
    OBBY_ASSIGN(recipe, readRecipe(a.text("recipe")));
  }
  if (a.has("style")) recipe.styles.clear();
  for (const std::string& name : a.list("style")) {
    OBBY_RETURN_IF_ERROR(checkStyle(name));
    recipe.styles.push_back({name, 1});
  }
  if (a.has("difficulty")) {
    OBBY_ASSIGN(recipe.difficulty, rangeOf(a.text("difficulty")));
  }
  return recipe;
}

std::string listOfStyles() {
  std::string text;
  for (const gen::Style& s : gen::styles()) {
    text += fmt::format("{:<13} {}\n", s.name, s.description);
  }
  return text;
}

}  // namespace obby::tools
