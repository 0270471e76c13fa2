#include "cli/help.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/check_value.h"
#include "io/version.h"

namespace obby::cli {
namespace {

constexpr size_t kColumns = 80, kHelpColumn = 28;

// `text` broken at spaces, every line but the first indented by `indent`; the first begins at `at`.
std::string wrapped(const std::string& text, size_t at, size_t indent) {
  std::string out;
  size_t column = at;
  for (size_t i = 0; i < text.size();) {
    const size_t space = std::min(text.find(' ', i), text.size());
    const std::string word = text.substr(i, space - i);
    const bool lineStart = column == indent;
    if (!lineStart && column + word.size() + 1 > kColumns) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (i > 0 && !lineStart) {
      out += ' ';
      column++;
    }
    out += word;
    column += word.size();
    i = space + 1;
  }
  return out;
}

// Lines that fit stay as they are.
std::string paragraphs(const std::string& text) {
  std::string out;
  for (size_t i = 0; i <= text.size();) {
    const size_t end = std::min(text.find('\n', i), text.size());
    const std::string line = text.substr(i, end - i);
    out += (line.size() > kColumns ? wrapped(line, 0, 0) : line) + '\n';
    i = end + 1;
  }
  return out;
}

std::string usageLine(const ToolSpec& spec) {
  return fmt::format("Usage: {} [OPTION]...{}", spec.name, spec.takesInputs ? " [FILE]..." : "");
}

std::string optionNames(const OptionRow& row) {
  std::string out = row.letter ? fmt::format("  -{}, --{}", row.letter, row.name)
                               : fmt::format("      --{}", row.name);
  const std::string label = valueLabel(row);
  if (row.type == ValueType::mode) return out + "[=" + label + "]";
  return label.empty() ? out : out + " " + label;
}

std::string optionHelp(const OptionRow& row) {
  std::string out = optionNames(row);
  std::string text = row.help;
  if (!row.defaultText.empty()) text += fmt::format(" [default: {}]", row.defaultText);
  if (row.repeatable) text += " (may be given more than once)";
  if (out.size() + 2 > kHelpColumn) {
    out += '\n' + std::string(kHelpColumn, ' ');
  } else {
    out += std::string(kHelpColumn - out.size(), ' ');
  }
  return out + wrapped(text, kHelpColumn, kHelpColumn) + "\n";
}

std::string examples(const ToolSpec& spec) {
  std::string out = "Examples:\n";
  for (const Example& example : spec.examples)
    out += fmt::format("  # {}\n  $ {}\n", example.text, example.command);
  return out;
}

std::vector<std::string> groups(const std::vector<OptionRow>& rows) {
  std::vector<std::string> out;
  for (const OptionRow& row : rows)
    if (std::find(out.begin(), out.end(), row.group) == out.end()) out.push_back(row.group);
  return out;
}

}  // namespace

std::string versionLine(const ToolSpec& spec) {
  return fmt::format("{} {}", spec.name, io::toolVersion());
}

std::string helpText(const ToolSpec& spec, const std::vector<OptionRow>& rows) {
  std::string out = fmt::format("{}\n{}.\n\n{}\n{}\n", versionLine(spec),
                                wrapped(spec.summary, 0, 0), examples(spec), usageLine(spec));
  if (spec.takesInputs)
    out +=
        wrapped(fmt::format("FILE: {}; - or none is standard input.", spec.inputHelp), 0, 0) + "\n";
  for (const std::string& group : groups(rows)) {
    out += fmt::format("\n{}:\n", group);
    for (const OptionRow& row : rows)
      if (row.group == group) out += optionHelp(row);
  }
  out += "\n" +
         wrapped(
             "Every option can also be set by a variable (OBBY_SEED for --seed) or in "
             "the --config file; the command line counts before variables, and these before the "
             "file. What would do nothing beside the other options is refused where it is typed, "
             "and passed over where it is set so.",
             0, 0) +
         "\n";
  if (!spec.notes.empty()) out += "\n" + paragraphs(spec.notes);
  return out;
}

std::string shortHelp(const ToolSpec& spec) {
  return fmt::format("{}: {}\n\n{}\n{}\nNo FILE, and standard input is a terminal: see {} --help\n",
                     spec.name, spec.summary, examples(spec), usageLine(spec), spec.name);
}

}  // namespace obby::cli
