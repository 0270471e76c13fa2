#include "cli/command_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace obby::cli {

std::string shellWord(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string optionText(const std::string& name, const Arguments::Value& value) {
  if (value.row.type == ValueType::flag) {
    const bool on = !value.texts.empty() && value.texts.back() == "true";  // the flag may be set to
                                                                           // false
    return on ? "--" + name : std::string();
  }
  const char separator = value.row.type == ValueType::mode ? '=' : ' ';
  std::string words;
  for (const std::string& text : value.texts)
    words += fmt::format("{}--{}{}{}", words.empty() ? "" : " ", name, separator, shellWord(text));
  return words;
}

namespace {

bool contains(std::initializer_list<const char*> names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::string commandText(const std::string& tool, const Arguments& arguments,
                        std::initializer_list<const char*> without) {
  std::string command = tool;
  for (const auto& [name, value] : arguments.values) {
    const std::string words = optionText(name, value);
    if (value.given && !contains(without, name) && !words.empty()) command += " " + words;
  }
  for (const std::string& input : arguments.inputs) {
    if (input != "-") command += " " + shellWord(input);
  }
  return command;
}

std::vector<std::string> optionTexts(const Arguments& a,
                                     std::initializer_list<const char*> without) {
  std::vector<std::string> out;
  for (const auto& [name, value] : a.values) {
    if (contains(without, name)) continue;
    const std::string words = optionText(name, value);
    out.push_back(words.empty() ? "without --" + name : "with " + words);
  }
  out.push_back(fmt::format("with {} input{}", a.inputs.size(), a.inputs.size() == 1 ? "" : "s"));
  for (const std::string& input : a.inputs) out.push_back("with the input " + shellWord(input));
  return out;
}

}  // namespace obby::cli
