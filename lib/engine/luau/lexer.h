// Splits Luau source text into tokens with line numbers, without comments. It never fails: a
// malformed token carries its error, and reading continues after it.
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
  symbol,         // symbol, or a byte that begins no token
  end
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string text;             // value of a string
  double number = 0;            // value of a number
  int line = 0;                 // line of its first byte, from 1
  bool opens = false;           // an interpolated string continues with an expression
  const char* error = nullptr;  // the error of a malformed token, in plain words
};

class Lexer {
 public:
  explicit Lexer(std::string_view source);

  // Reads the next token. After the last one, its kind is always end.
  void read(Token& token);

 private:
  char peek(size_t ahead = 0) const {
    return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
  }
  Token& push(TokenKind kind, std::string_view text);
  void advanceTo(size_t end);
  void step();  // skips a blank or a comment, or reads one token
  void symbol(char c);
  void comment();
  void word();
  void number();
  // Reads up to a quote, or up to `other`, which is not consumed. Returns false if the line ends
  // first.
  bool text(char quote, char other, Token& token);
  void quoted(char quote);
  // Reads a section of an interpolated string, up to its end or to the next expression.
  void section(TokenKind kind);
  // Returns one more than the level of the long bracket that opens here, or 0 if none does.
  size_t longBracket() const;
  size_t longBracketEnd(size_t level) const;
  bool longString();

  std::string_view source_;
  size_t at_ = 0;
  int line_ = 1;
  std::vector<bool> braces_;  // open braces; true if opened by an interpolated string
  Token* token_ = nullptr;    // the token to fill
};

// Returns all tokens. The last one has the kind end.
std::vector<Token> tokenize(std::string_view source);

}  // namespace obby::luau
