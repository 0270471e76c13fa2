#include "cli/completion.h"

#include <fmt/format.h>

namespace obby::cli {
namespace {

std::string identifier(const ToolSpec& spec) {
  std::string out = "_" + spec.name;
  for (char& c : out)
    if (c == '-') c = '_';
  return out;
}

// Escapes text for single quotes of any shell.
std::string quotedHelp(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out;
}

// Reads one name per line, so that names may contain blanks.
constexpr const char* kBashFiles = "mapfile -t COMPREPLY < <(compgen -f -- \"$word\")";

std::string bash(const ToolSpec& spec, const std::vector<OptionRow>& rows) {
  std::string words, cases;
  for (const OptionRow& row : rows) {
    words += " --" + row.name;
    if (row.letter) words += std::string(" -") + row.letter;
    if (row.type == ValueType::mode)
      for (const std::string& choice : row.choices) words += " --" + row.name + "=" + choice;
    if (!takesWord(row)) continue;
    std::string pattern = "--" + row.name;
    if (row.letter) pattern += std::string("|-") + row.letter;
    const std::string reply = row.type == ValueType::file ? kBashFiles
                              : row.choices.empty()
                                  ? "COMPREPLY=()"
                                  : fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"))",
                                                fmt::join(row.choices, " "));
    cases += fmt::format("    {}) {}; return ;;\n", pattern, reply);
  }
  return fmt::format(
      "{0}() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}\n"
      "  case $before in\n{1}  esac\n"
      "  if [[ $word == -* ]]; then COMPREPLY=($(compgen -W '{2}' -- \"$word\")); return; fi\n"
      "  {4}\n"
      "}}\n"
      "complete -o filenames -F {0} {3}\n",
      identifier(spec), cases, words.substr(1), spec.name, kBashFiles);
}

// Escapes brackets and colons, which have a meaning in zsh's specifications.
std::string zshHelp(const std::string& text) {
  std::string out;
  for (const char c : quotedHelp(text)) {
    if (c == '[' || c == ']' || c == ':') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh(const ToolSpec& spec, const std::vector<OptionRow>& rows) {
  std::string out = fmt::format("#compdef {}\n_arguments -s -S", spec.name);
  for (const OptionRow& row : rows) {
    std::string value;
    if (!row.choices.empty()) {
      value = fmt::format("{}value:({})", row.type == ValueType::mode ? "::" : ":",
                          fmt::join(row.choices, " "));
    } else if (row.type == ValueType::file) {
      value = ":file:_files";
    } else if (takesWord(row)) {
      value = ":value: ";
    }
    const std::string repeat = row.repeatable ? "*" : "";
    const std::string equals = row.type == ValueType::mode ? "=-" : takesWord(row) ? "=" : "";
    out +=
        fmt::format(" \\\n  '{}--{}{}[{}]{}'", repeat, row.name, equals, zshHelp(row.help), value);
    if (row.letter)
      out += fmt::format(" \\\n  '{}-{}[{}]{}'", repeat, row.letter, zshHelp(row.help), value);
  }
  return out + (spec.takesInputs ? " \\\n  '*:file:_files'\n" : "\n");
}

std::string fish(const ToolSpec& spec, const std::vector<OptionRow>& rows) {
  std::string out;
  for (const OptionRow& row : rows) {
    out += fmt::format("complete -c {} -l {}", spec.name, row.name);
    if (row.letter) out += fmt::format(" -s {}", row.letter);
    if (row.type == ValueType::file) {
      out += " -r -F";
    } else if (takesWord(row)) {
      out += " -x";
    }
    if (!row.choices.empty()) out += fmt::format(" -a '{}'", fmt::join(row.choices, " "));
    out += fmt::format(" -d '{}'\n", quotedHelp(row.help));
  }
  return out;
}

}  // namespace

std::string completionScript(const ToolSpec& spec, const std::vector<OptionRow>& all,
                             const std::string& shell) {
  std::vector<OptionRow> rows;
  for (const OptionRow& row : all)
    if (!row.hidden) rows.push_back(row);
  if (shell == "bash") return bash(spec, rows);
  return shell == "zsh" ? zsh(spec, rows) : fish(spec, rows);
}

}  // namespace obby::cli
