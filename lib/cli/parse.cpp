#include "cli/parse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/spelling.h"
#include "io/text.h"

namespace obby::cli {
namespace {

// CLI11 splits a value in brackets, and replaces an empty value after "=" by the next word, perhaps
// a file. A mark before the value prevents both.
constexpr char kMark = '\x01';

// Returns where the value begins in "--name=value". Other words are values from their start.
size_t valueBegin(const std::string& word) {
  const size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
  return equals == std::string::npos ? 0 : equals + 1;
}

std::string marked(std::string word) {
  const size_t begin = valueBegin(word);
  const bool empty = begin > 0 && begin == word.size();
  if (empty || (begin < word.size() && word[begin] == '[')) word.insert(begin, 1, kMark);
  return word;
}

// Removes the mark from a word, or from the value in it.
std::string unmarked(std::string word) {
  const size_t begin = valueBegin(word);
  if (begin < word.size() && word[begin] == kMark) word.erase(begin, 1);
  return word;
}

CLI::Option* addRow(CLI::App& app, const OptionRow& row) {
  const bool isMode = row.type == ValueType::mode;
  const std::string bare = isMode ? "{" + row.bare + "}" : std::string();
  std::string names = "--" + row.name + bare;
  if (!row.formerly.empty()) names += ",--" + row.formerly + bare;
  if (row.letter) names = std::string("-") + row.letter + "," + names;
  if (row.type == ValueType::flag || isMode)
    return app.add_flag(names)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  CLI::Option* option = app.add_option(names);
  return option->expected(1)->multi_option_policy(
      row.repeatable ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::TakeLast);
}

Error optionError(const std::string& name, std::string message, std::string hint = {}) {
  return Error{{}, {}, name, std::move(message), std::move(hint)};
}

Error unknownArgument(const std::string& text, const std::vector<OptionRow>& rows,
                      const ToolSpec& spec) {
  if (text.size() < 2 || text[0] != '-')
    return makeError("unexpected argument " + io::quoted(text), "see " + spec.name + " --help");
  const std::string name = text.substr(0, text.find('='));
  std::vector<std::string> known;
  for (const OptionRow& row : rows)
    if (!row.hidden) known.push_back("--" + row.name);
  const std::string near = name.size() > 2 ? nearestName(name, known) : "";
  return optionError(name, "unknown option",
                     near.empty() ? "see " + spec.name + " --help" : "did you mean " + near + "?");
}

// CLI11 says "--seed: 1 required TEXT missing", of which only the option's name is useful.
Error parseError(const CLI::ParseError& e, const std::vector<OptionRow>& rows) {
  const std::string what = e.what();
  for (const OptionRow& row : rows) {
    const std::string name = "--" + row.name;
    if (what.find(name + ":") == std::string::npos) continue;
    return optionError(name, row.type == ValueType::flag ? "takes no value" : "needs a value");
  }
  return makeError(what);
}

}  // namespace

std::vector<OptionRow> allRows(const ToolSpec& spec) {
  std::vector<OptionRow> out = spec.options;
  out.insert(out.end(), universalRows().begin(), universalRows().end());
  return out;
}

CommandLine parseCommandLine(const ToolSpec& spec, const std::vector<OptionRow>& rows, int argc,
                             char** argv) {
  CommandLine out;
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<CLI::Option*> options;
  for (const OptionRow& row : rows) options.push_back(addRow(app, row));
  CLI::Option* inputs =
      spec.takesInputs ? app.add_option("FILE")->expected(0, 1 << 20)->allow_extra_args() : nullptr;
  std::vector<std::string> words;
  for (int i = argc - 1; i > 0; i--) words.push_back(marked(argv[i]));  // CLI11 takes them reversed
  try {
    app.parse(words);
  } catch (const CLI::ParseError& e) {
    out.wrong = parseError(e, rows);
  }
  for (size_t i = 0; i < rows.size(); i++) {
    for (const std::string& text : options[i]->results())
      out.texts[rows[i].name].push_back(unmarked(text));
    if (options[i]->count() > 0 && out.texts[rows[i].name].empty())
      out.texts[rows[i].name].push_back("");
  }
  if (inputs)
    for (const std::string& text : inputs->results()) out.inputs.push_back(unmarked(text));
  std::vector<std::string> extras = app.remaining();
  std::erase(extras, "--");
  if (out.wrong && !extras.empty())
    out.wrong = unknownArgument(unmarked(extras.front()), rows, spec);
  return out;
}

}  // namespace obby::cli
