#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/check_value.h"
#include "cli/commit.h"
#include "cli/console.h"
#include "cli/wrap.h"
#include "io/version.h"

namespace obby::cli {
namespace {

constexpr size_t kNarrowest = 40, kWidest = 120;
constexpr size_t kTwoColumns = 64;                     // min width for two columns
constexpr size_t kHelpColumn = 28, kNarrowColumn = 8;  // column in which an option's text begins
// Columns of an option's long name, and of its continuation lines.
constexpr size_t kNameColumn = 6, kNameIndent = 10;
constexpr size_t kFewExamples = 5;  // number of examples in --help

std::string usageLine(const ToolSpec& spec, size_t width) {
  return wrapped(fmt::format("Usage: {} {}", spec.name, usageWords(spec)), 0, 4, width) + "\n";
}

std::string optionNames(const OptionRow& row, size_t width) {
  std::string name = "--" + row.name;
  const std::string label = valueLabel(row);
  if (row.type == ValueType::mode) {
    name += "[=" + label + "]";
  } else if (!label.empty()) {
    name += " " + label;
  }
  if (row.repeatable) name += "...";
  const std::string letter = row.letter ? fmt::format("  -{}, ", row.letter) : "      ";
  return letter + wrapped(name, kNameColumn, kNameIndent, width);
}

std::string optionHelp(const OptionRow& row, const HelpStyle& style) {
  const size_t column = style.width >= kTwoColumns ? kHelpColumn : kNarrowColumn;
  std::string text = row.help;
  if (!row.defaultText.empty()) text += fmt::format(" [default: {}]", row.defaultText);
  if (!style.all && row.details.find('\n') != std::string::npos) text += " (see --help-all)";
  std::string out = optionNames(row, style.width);
  if (out.size() + 2 > column) {
    out += '\n' + std::string(column, ' ');
  } else {
    out += std::string(column - out.size(), ' ');
  }
  out += wrapped(text, column, column, style.width) + "\n";
  if (!row.details.empty() && style.all) out += wrappedLines(row.details, column, style.width);
  return out;
}

std::string examples(const ToolSpec& spec, const HelpStyle& style) {
  std::string out = "Examples:\n";
  const size_t count = style.all ? spec.examples.size() : kFewExamples;
  for (size_t i = 0; i < std::min(count, spec.examples.size()); i++) {
    const Example& example = spec.examples[i];
    out += "  # " + wrapped(example.text, 4, 4, style.width) + "\n";
    out += "  $ " + wrappedCommand(example.command, 4, style.width) + "\n";
  }
  return out;
}

bool isShown(const OptionRow& row, const HelpStyle& style) {
  return !row.hidden && (style.all || !row.rare);
}

std::string optionList(const std::vector<OptionRow>& rows, const HelpStyle& style) {
  std::vector<OptionRow> shown;
  for (const OptionRow& row : rows)
    if (isShown(row, style)) shown.push_back(row);
  std::string out;
  for (const std::string& group : optionGroups(shown)) {
    out += "\n" + wrappedLines(group + ":", 0, style.width);
    for (const OptionRow& row : shown)
      if (row.group == group) out += optionHelp(row, style);
  }
  return out;
}

}  // namespace

const char* const kOtherSources =
    "Any option can also be set with an environment variable (OBBY_QUIET for --quiet) or in the "
    "--config file. The command line wins, then variables, then the file. An option without effect "
    "is an error on the command line and ignored elsewhere.";

size_t helpWidth(int descriptor) {
  return std::clamp(terminalWidth(descriptor), kNarrowest, kWidest);
}

std::string versionLine(const ToolSpec& spec) {
  const std::string commit = *kCommit ? fmt::format("commit {}, ", kCommit) : "";
  return fmt::format("{} {} ({}schema {}.{})", spec.name, io::toolVersion(), commit,
                     io::kSchemaMajor, io::kSchemaMinor);
}

std::string usageWords(const ToolSpec& spec) {
  return spec.takesInputs ? "[OPTION]... [FILE]..." : "[OPTION]...";
}

std::vector<std::string> optionGroups(const std::vector<OptionRow>& rows) {
  std::vector<std::string> out;
  for (const OptionRow& row : rows)
    if (std::find(out.begin(), out.end(), row.group) == out.end()) out.push_back(row.group);
  if (const auto last = std::find(out.begin(), out.end(), kHelpGroup); last != out.end())
    std::rotate(last, last + 1, out.end());
  return out;
}

std::string helpText(const ToolSpec& spec, const std::vector<OptionRow>& rows,
                     const HelpStyle& style) {
  const auto paragraph = [&](const std::string& text) {
    return text.empty() ? "" : "\n" + wrappedLines(text, 0, style.width);
  };
  std::string out = fmt::format("{} {}\n", spec.name, io::toolVersion());
  out += wrappedLines(sentence(spec.summary), 0, style.width) + "\n" + examples(spec, style) +
         "\n" + usageLine(spec, style.width);
  if (spec.takesInputs)
    out += wrappedLines(fmt::format("FILE: {}; - or no FILE means standard input.", spec.inputHelp),
                        0, style.width);
  out += optionList(rows, style) + paragraph(spec.notes);
  if (style.all) out += paragraph(spec.details);
  out += paragraph(kOtherSources);
  const bool repeats =
      std::any_of(rows.begin(), rows.end(), [](const OptionRow& row) { return row.repeatable; });
  std::string end = repeats ? "Options with ... may be repeated." : "";
  if (!style.all)
    end += fmt::format("{}All options: {} --help-all", end.empty() ? "" : " ", spec.name);
  return out + paragraph(end);
}

std::string shortHelp(const ToolSpec& spec, size_t width) {
  HelpStyle style;
  style.width = width;
  return wrappedLines(spec.name + ": " + spec.summary + ".", 0, width) + "\n" +
         examples(spec, style) + "\n" + usageLine(spec, width) +
         wrappedLines(fmt::format("No FILE was given, and standard input is a terminal. See {} "
                                  "--help.",
                                  spec.name),
                      0, width);
}

}  // namespace obby::cli
