// The parser's state and its two halves: statements (parser.cpp) and expressions
// (expression_parser.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/luau/ast.h"
#include "engine/luau/lexer.h"

namespace obby::luau {

class Parser {
 public:
  explicit Parser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  Block block();
  bool atEnd() const { return peek().kind == TokenKind::end; }
  bool broken() const { return broken_; }
  void skipStray() {
    broken_ = true;
    next();
  }

 private:
  static constexpr int kMaxDepth = 100;   // nested blocks and brackets
  static constexpr int kMaxHeight = 150;  // of one expression

  // One more level of nesting while it lives.
  class Depth {
   public:
    explicit Depth(Parser& parser) : parser_(parser) { ++parser_.depth_; }
    ~Depth() { --parser_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    bool tooDeep() const { return parser_.depth_ > kMaxDepth; }

   private:
    Parser& parser_;
  };

  // Statements.
  bool blockEnds() const;
  StatPtr statement();
  StatPtr local(int line);
  StatPtr branch(int line);
  StatPtr loop(int line);
  StatPtr namedFunction(int line);
  StatPtr typeDeclaration();
  StatPtr callOrAssignment(int line);
  bool isCallOrAssignmentAhead() const;

  // Expressions.
  ExprPtr expression(int least = 0);
  ExprPtr unary();
  ExprPtr simple();
  ExprPtr primary();  // null if none begins here
  ExprPtr literal();  // a string token
  ExprPtr suffixes(ExprPtr from);
  ExprPtr table();
  ExprPtr choice();
  ExprPtr functionBody(int line);
  void arguments(Expr& call);
  std::vector<ExprPtr> expressionList();
  void skipType();
  void skipTypeAtom();
  void skipUntil(std::string_view symbol);
  ExprPtr make(ExprKind kind, std::string text = {}) const;
  // Adds a kid; one that would make the expression too high becomes unknown.
  void adopt(Expr& parent, ExprPtr kid);

  // Tokens.
  const Token& peek(size_t ahead = 0) const {
    return tokens_[position_ + ahead < tokens_.size() ? position_ + ahead : tokens_.size() - 1];
  }
  const Token& next() {
    const Token& token = peek();
    if (position_ + 1 < tokens_.size()) ++position_;
    return token;
  }
  bool isSymbol(std::string_view text) const {
    return peek().kind == TokenKind::symbol && peek().text == text;
  }
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
  void expectKeyword(std::string_view keyword) {
    if (!acceptKeyword(keyword)) broken_ = true;
  }
  void expect(std::string_view symbol) {
    if (!accept(symbol)) broken_ = true;
  }
  std::string nameToken() {
    if (peek().kind == TokenKind::name) return next().text;
    broken_ = true;
    return {};
  }

  std::vector<Token> tokens_;
  size_t position_ = 0;
  int depth_ = 0;
  bool broken_ = false;
};

}  // namespace obby::luau
