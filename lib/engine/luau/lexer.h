// Luau source text as tokens with line numbers; comments are left out. Never fails: what is no
// token is skipped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby::luau {

enum class TokenKind { name, keyword, number, string, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;   // of a string: its value
  double number = 0;  // of a number
  int line = 0;       // from 1
  bool known = true;  // a string whose value the text tells, unlike `a{b}`
};

// Always ends with a token of kind end.
std::vector<Token> tokenize(std::string_view source);

}  // namespace obby::luau
