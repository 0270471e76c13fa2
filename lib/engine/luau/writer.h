// Writes Lua text at given lines.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace obby::luau {

class Writer {
 public:
  // Moves on to a line, unless the text is past that line already or stays on its line.
  void at(int line) {
    for (; line_ < line && !stays_; ++line_) text_ += '\n';
  }
  // If `stays`, later text stays on the current line. Returns the previous value.
  bool stay(bool stays) { return std::exchange(stays_, stays); }
  // Writes a name, a keyword or a number.
  void word(std::string_view word) {
    if (!text_.empty() && isWordPart(text_.back())) text_ += ' ';
    text_ += word;
  }
  // Writes any other token.
  void symbol(std::string_view symbol) {
    if (symbol[0] == '-' && !text_.empty() && text_.back() == '-') text_ += ' ';
    text_ += symbol;
  }
  std::string take() { return std::move(text_); }

 private:
  static bool isWordPart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  }

  std::string text_;
  int line_ = 1;
  bool stays_ = false;
};

}  // namespace obby::luau
