// Lua text in lines that are given.
#pragma once

#include <string>
#include <string_view>

namespace obby::luau {

class Writer {
 public:
  // Goes on in a line, unless it is already beyond it.
  void at(int line) {
    for (; line_ < line; ++line_) text_ += '\n';
  }
  // A name, a keyword or a number.
  void word(std::string_view word) {
    if (!text_.empty() && isWordPart(text_.back())) text_ += ' ';
    text_ += word;
  }
  // Anything else.
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
};

}  // namespace obby::luau
