// Luau source text as tokens with line numbers; comments are left out. Never fails: a malformed
// token says so, and the text behind it goes on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obby::luau {

enum class TokenKind {
  name,
  keyword,
  number,
  string,
  interpolation,  // `text` or `text{
  continuation,   // }text` or }text{
  symbol,         // also a byte that begins no token
  end
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;             // of a string: its value
  double number = 0;            // of a number
  int line = 0;                 // of its first byte, from 1
  bool opens = false;           // an interpolated string goes on with an expression
  const char* error = nullptr;  // what is malformed, in plain words
};

// Always ends with a token of kind end.
std::vector<Token> tokenize(std::string_view source);

}  // namespace obby::luau
