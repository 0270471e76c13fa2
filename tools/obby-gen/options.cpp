// The option table of obby-gen and what its options mean to lib/gen.
#include "options.h"

#include <fmt/format.h>

#include "cli/rows.h"
#include "gen/styles.h"
#include "shared/recipe_options.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::OptionRow;
using cli::row;
using cli::ValueType;

constexpr const char* kLevelGroup = "Levels";
constexpr const char* kCheckGroup = "Checking";

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
      row("unsolvable", ValueType::flag, "", "",
          "write of each level the twin in which one crossing is beyond reach; its name says which",
          kLevelGroup),
      row("twins", ValueType::flag, "", "",
          "write behind each level that twin, too: --count counts pairs, and --check keeps both or "
          "none",
          kLevelGroup),
      cli::commonRow(cli::Common::seed),
      row("list", ValueType::flag, "", "",
          "print the styles and exit; with --style: what a recipe may set of these", kLevelGroup),
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

std::string lineOf(const gen::Style& s) {
  return fmt::format("{:<13} {}\n", s.name, s.description);
}

std::string lineOf(const gen::Parameter& p) {
  const std::string unit = *p.unit == 0 ? "" : fmt::format("{}, ", p.unit);
  const std::string range = fmt::format("{:g} to {:g}", p.least, p.most);
  return fmt::format("  {:<11} {:>7.4g}  {:>7.4g}  {:<12} {}{}\n", p.name, p.easy, p.hard, range,
                     unit, p.description);
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
  for (const auto& rows : {levelRows(), recipeRows(kLevelGroup), checkRows()}) {
    spec.options.insert(spec.options.end(), rows.begin(), rows.end());
  }
  spec.notes =
      "What is written depends on --seed, --first, --count and the recipe only, never on --threads "
      "or the machine. Level N of a seed without and with --unsolvable are twins: alike but for "
      "one "
      "crossing.";
  return spec;
}

std::string listOfStyles(const gen::Recipe& recipe) {
  if (recipe.styles.empty()) {
    std::string text;
    for (const gen::Style& s : gen::styles()) text += lineOf(s);
    return text;
  }
  std::string text =
      fmt::format("{:<13} {:>7}  {:>7}  {:<12} {}\n", "", "trivial", "limit", "may be", "what");
  for (const gen::NamedNumber& asked : recipe.styles) {
    const gen::Style& s = *gen::findStyle(asked.name);
    text += lineOf(s);
    for (const gen::Parameter& p : s.parameters) text += lineOf(p);
  }
  return text;
}

}  // namespace obby::tools
