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

class Lexer {
 public:
  explicit Lexer(std::string_view source);

  // The next token; of kind end for ever after the last.
  void read(Token& token);

 private:
  char peek(size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }
  Token& push(TokenKind kind, std::string_view text);
  void advanceTo(size_t end);
  void step();  // one token, blank or comment
  void symbol(char c);
  void comment();
  void word();
  void number();
  // Reads up to a quote, or to one of two bytes, which stays; false if the line ends before.
  bool text(char quote, char other, Token& token);
  void quoted(char quote);
  // Of an interpolated string, up to its end or to the next expression.
  void section(TokenKind kind);
  // One more than the level of the long bracket that opens here; 0: none does.
  size_t longBracket() const;
  size_t longBracketEnd(size_t level) const;
  bool longString();

  std::string_view source_;
  size_t at_ = 0;
  int line_ = 1;
  std::vector<bool> braces_;  // open ones; true: of an interpolated string
  Token* token_ = nullptr;    // to be filled
};

// All of them; always ends with a token of kind end.
std::vector<Token> tokenize(std::string_view source);

}  // namespace obby::luau
