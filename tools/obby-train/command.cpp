#include "command.h"

#include <fmt/format.h>

namespace obby::tools {

std::string wordOf(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string asTyped(const std::string& name, const cli::Arguments::Value& value) {
  if (value.row.type == cli::ValueType::flag) {
    const bool on = !value.texts.empty() && value.texts.back() == "true";  // or set to false
    return on ? "--" + name : std::string();
  }
  const char joint = value.row.type == cli::ValueType::mode ? '=' : ' ';
  std::string words;
  for (const std::string& text : value.texts)
    words += fmt::format("{}--{}{}{}", words.empty() ? "" : " ", name, joint, wordOf(text));
  return words;
}

std::string commandOf(const cli::Arguments& arguments) {
  std::string command = "obby-train";
  for (const auto& [name, value] : arguments.values) {
    const std::string words = asTyped(name, value);
    if (value.given && name != "resume" && !words.empty()) command += " " + words;
  }
  for (const std::string& input : arguments.inputs) {
    if (input != "-") command += " " + wordOf(input);
  }
  return command;
}

}  // namespace obby::tools
