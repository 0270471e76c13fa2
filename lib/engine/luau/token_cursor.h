// The position of a parser in the tokens of a script, and the first error that it finds.
#pragma once

#include <string>
#include <string_view>

#include "engine/luau/lexer.h"

namespace obby::luau {

class TokenCursor {
 public:
  explicit TokenCursor(std::string_view source) : lexer_(source) {
    lexer_.read(tokens_[0]);
    lexer_.read(tokens_[1]);
  }

 protected:
  static constexpr int kMaxDepth = 150;  // max nested blocks and brackets

  // Adds one level of nesting while it exists.
  class Depth {
   public:
    explicit Depth(TokenCursor& cursor) : cursor_(cursor) { ++cursor_.depth_; }
    ~Depth() { --cursor_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    // Returns true if the nesting is too deep. Then it reports this and skips a token, so that a
    // caller's loop makes progress.
    bool tooDeep() const;

   private:
    TokenCursor& cursor_;
  };

  // Errors. The first one counts.
  void fail(int line, std::string message);
  void failHere(std::string_view expected);  // "expected X, found Y"
  std::string found() const;

  // Tokens. Three are kept: the one before, the current one and the next one.
  const Token& peek(size_t ahead = 0) const { return tokens_[(current_ + ahead) % 3]; }
  // The reference is valid until the next call.
  const Token& next() {
    const Token& token = peek();
    if (token.error) fail(token.line, token.error);
    if (token.kind == TokenKind::end) return token;
    ++position_;
    current_ = (current_ + 1) % 3;
    lexer_.read(tokens_[(current_ + 1) % 3]);
    return token;
  }
  bool atEnd() const { return peek().kind == TokenKind::end; }
  int lineBefore() const { return peek(2).line; }  // valid only after a first token
  static bool isSymbol(const Token& token, std::string_view text) {
    return token.kind == TokenKind::symbol && token.text == text;
  }
  bool isSymbol(std::string_view text) const { return isSymbol(peek(), text); }
  bool isKeyword(std::string_view text) const {
    return peek().kind == TokenKind::keyword && peek().text == text;
  }
  bool isName(std::string_view text) const {
    return peek().kind == TokenKind::name && peek().text == text;
  }
  bool accept(std::string_view symbol) {
    const bool found = isSymbol(symbol);
    if (found) next();
    return found;
  }
  bool acceptKeyword(std::string_view keyword) {
    const bool found = isKeyword(keyword);
    if (found) next();
    return found;
  }
  void expectKeyword(std::string_view keyword);
  void expect(std::string_view symbol);
  // Expects the counterpart of an opening symbol. The error names the opener's line.
  void close(std::string_view symbol, std::string_view opener, int line);
  void closeKeyword(std::string_view keyword, std::string_view opener, int line);
  std::string nameToken();

  size_t position() const { return position_; }  // tokens read so far
  bool isBroken() const { return broken_; }
  const std::string& error() const { return error_; }
  int errorLine() const { return errorLine_; }

 private:
  Lexer lexer_;
  Token tokens_[3];
  size_t current_ = 0;
  size_t position_ = 0;
  int depth_ = 0;
  bool broken_ = false;
  std::string error_;
  int errorLine_ = 0;
};

}  // namespace obby::luau
