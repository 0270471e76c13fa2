#include "cli/parse.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/spelling.h"
#include "cli/rows.h"
#include "io/text.h"

namespace obby::cli {
namespace {

constexpr int kMaxInputs = 1 << 20;

// Returns the row of `--name=` without a value, or null.
const OptionRow* emptyRow(std::string_view word, const std::vector<OptionRow>& rows) {
  if (!word.starts_with("--") || !word.ends_with('=')) return nullptr;
  const std::string_view name = word.substr(2, word.size() - 3);
  const auto found = std::ranges::find(rows, name, &OptionRow::name);
  return found == rows.end() ? nullptr : &*found;
}

struct Words {
  std::vector<std::string> forParser;
  std::vector<std::string> emptyFlags;  // names of flags that were given as `--name=`
};

// CLI11 takes the next word, perhaps a file, as the value of `--name=`. So an empty value becomes a
// word of its own, and the empty value of a flag is hidden from CLI11.
Words wordsOf(const std::vector<OptionRow>& rows, int argc, char** argv) {
  Words out;
  bool optionsEnd = false;
  for (int i = 1; i < argc; i++) {
    optionsEnd = optionsEnd || std::string_view(argv[i]) == "--";
    const OptionRow* row = optionsEnd ? nullptr : emptyRow(argv[i], rows);
    if (!row) {
      out.forParser.emplace_back(argv[i]);
    } else if (takesWord(*row)) {
      out.forParser.insert(out.forParser.end(), {"--" + row->name, ""});
    } else {
      out.emptyFlags.push_back(row->name);
    }
  }
  std::ranges::reverse(out.forParser);  // CLI11 expects this order
  return out;
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
  CLI::Option* inputs = nullptr;
  if (spec.takesInputs) {
    // Fewer inputs are no error with CLI11's policy.
    inputs = app.add_option("FILE")->expected(kMaxInputs);
    inputs->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  Words words = wordsOf(rows, argc, argv);
  try {
    app.parse(words.forParser);
  } catch (const CLI::ParseError& e) {
    out.wrong = parseError(e, rows);
  }
  for (size_t i = 0; i < rows.size(); i++) {
    if (options[i]->count() > 0) out.texts[rows[i].name] = options[i]->results();
  }
  for (const std::string& name : words.emptyFlags) out.texts[name].emplace_back();
  if (inputs) out.inputs = inputs->results();
  std::vector<std::string> extras = app.remaining();
  std::erase(extras, "--");
  if (out.wrong && !extras.empty()) out.wrong = unknownArgument(extras.front(), rows, spec);
  return out;
}

}  // namespace obby::cli
