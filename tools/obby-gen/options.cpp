// The option table of obby-gen, and its translation to lib/gen.
#include "options.h"

#include <fmt/format.h>

#include "cli/rows.h"
#include "gen/styles.h"
#include "shared/recipe_options.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::flagRow;
using cli::OptionRow;
using cli::row;
using cli::ValueType;

constexpr const char* kLevelGroup = "Levels to generate";
constexpr const char* kCheckGroup = "Check with the solver";

OptionRow formatRow() {
  OptionRow r = cli::commonRow(cli::Common::format);
  r.choices.push_back("rbxlx");
  r.help =
      "output encoding; rbxlx: a place file for Studio with all levels side by side [default: by "
      "the output file's extension, else jsonl]";
  r.details += " An interrupted run writes no place file.";
  return r;
}

std::vector<OptionRow> levelRows() {
  return {
      between(row("count", ValueType::integer, "N", "1",
                  "number of levels to write, not counting those that --check drops; 0: no limit",
                  kLevelGroup),
              0, 9e15),
      between(row("first", ValueType::integer, "N", "0",
                  "number of the first level; with the same options and seed, level N is the same "
                  "in every run",
                  kLevelGroup),
              0, 4e18),
      flagRow("unsolvable",
              "write an unsolvable twin of each level instead; its name says which gap or "
              "obstacle is impossible",
              kLevelGroup),
      flagRow(
          "twins",
          "write each level and then its unsolvable twin; --count counts pairs, and --check keeps "
          "both or neither",
          kLevelGroup),
      flagRow("list", "list the styles and exit; with --style: list the parameters of these styles",
              kLevelGroup),
  };
}

std::vector<OptionRow> checkRows() {
  return {
      flagRow(
          "check",
          "keep only levels that the solver solves or, with --unsolvable, proves unsolvable; the "
          "solver's answer is written after the query",
          kCheckGroup),
      between(row("check-steps", ValueType::integer, "N", "1000000",
                  "maximum steps (simulated ticks) of --check for each level", kCheckGroup),
              1, 9e15),
  };
}

std::string lineOf(const gen::Style& s) {
  return fmt::format("{:<13} {}\n", s.name, s.description);
}

std::string lineOf(const gen::Parameter& p) {
  const std::string unit = *p.unit == 0 ? "" : fmt::format("{}, ", p.unit);
  const std::string range = fmt::format("{:g} to {:g}", p.min, p.max);
  return fmt::format("  {:<11} {:>7.4g}  {:>7.4g}  {:<12} {}{}\n", p.name, p.easy, p.hard, range,
                     unit, p.description);
}

}  // namespace

cli::ToolSpec genSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-gen";
  spec.summary = "generate levels and the queries to ask about them";
  spec.takesInputs = false;
  spec.examples = {
      {"Generate a course, solve it and show it in a browser",
       "obby-gen --style course | obby-solve | obby-view -o course.html"},
      {"Generate a thousand levels of all styles",
       "obby-gen --count 1000 --seed 7 -o levels.capnp"},
      {"Generate jumps at a player's limit, each checked by the solver",
       "obby-gen --style gaps --difficulty limit --check --count 3 -o gaps.jsonl"},
      {"Generate unsolvable levels, each with one gap that is too wide",
       "obby-gen --style gaps --difficulty limit --unsolvable --count 3"},
      {"Generate a place file to open in Studio",
       "obby-gen --style course --difficulty easy -o course.rbxlx"},
  };
  spec.options = cli::joined(
      {{cli::commonRow(cli::Common::output), formatRow(), cli::commonRow(cli::Common::progress)},
       recipeRows(kLevelGroup, "the recipe's, else easy..hard"),
       levelRows(),
       checkRows(),
       {cli::commonRow(cli::Common::threads), cli::commonRow(cli::Common::seed)}});
  spec.notes =
      "The same options and recipe give the same output, on any machine and with any --threads. "
      "Level N of a seed and its unsolvable twin differ in one gap or obstacle only.";
  return spec;
}

std::string listOfStyles(const gen::Recipe& recipe) {
  if (recipe.styles.empty()) {
    std::string text;
    for (const gen::Style& s : gen::styles()) text += lineOf(s);
    return text;
  }
  std::string text =
      fmt::format("{:<13} {:>7}  {:>7}  {:<12} {}\n", "", "trivial", "limit", "range", "meaning");
  for (const gen::NamedNumber& asked : recipe.styles) {
    const gen::Style& s = *gen::findStyle(asked.name);
    text += lineOf(s);
    for (const gen::Parameter& p : s.parameters) text += lineOf(p);
  }
  return text;
}

}  // namespace obby::tools
