// The parser's state and its parts: statements (parser.cpp, loop_parser.cpp), expressions
// (expression_parser.cpp, suffix_parser.cpp) and types (type_parser.cpp).
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

  Chunk chunk();

 private:
  static constexpr int kMaxDepth = 150;    // nested blocks and brackets
  static constexpr int kMaxHeight = 1000;  // of one expression

  // One more level of nesting while it lives.
  class Depth {
   public:
    explicit Depth(Parser& parser) : parser_(parser) { ++parser_.depth_; }
    ~Depth() { --parser_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    // An error if so; skips a token, so that whoever repeats gets on.
    bool tooDeep() const;

   private:
    Parser& parser_;
  };
  // What `...`, `break` and `continue` may refer to.
  struct Surroundings {
    bool vararg = true;
    int loops = 0;
  };

  // Statements.
  Block block();
  bool blockEnds() const;
  void checkLast(const Stat& stat);
  StatPtr statement();
  StatPtr keywordStatement(int line);
  StatPtr contextualStatement(int line);  // null if the name that begins it has no special meaning
  StatPtr local(int line, const char* text);
  StatPtr localFunction(int line);
  StatPtr attributed(int line);
  StatPtr doBlock(int line);
  StatPtr branch(int line);
  StatPtr returns(int line);
  StatPtr leaves(int line);
  StatPtr whileLoop(int line);
  StatPtr repeatLoop(int line);
  StatPtr forLoop(int line);
  Block loopBody();
  StatPtr namedFunction(int line);
  StatPtr typeDeclaration(int line);
  StatPtr callOrAssignment(int line);
  StatPtr assignment(int line, ExprPtr first);
  void checkTarget(const Expr& target);
  bool continuesName() const;  // whether what follows a name makes it an expression

  // Expressions.
  ExprPtr expression(int least = 0);
  ExprPtr concatenation(ExprPtr first);
  ExprPtr unary();
  ExprPtr simple();
  ExprPtr keywordValue();  // null if none begins here
  ExprPtr vararg();
  ExprPtr primary();  // null if none begins here
  ExprPtr stringLiteral();
  ExprPtr interpolated();
  ExprPtr suffixes(ExprPtr from);
  ExprPtr suffix(ExprPtr& from);  // null if none begins here
  ExprPtr table();
  ExprPtr tableKey();  // null for a positional item
  ExprPtr choice();
  ExprPtr functionBody(int line);
  void parameters(Function& function);
  void arguments(Expr& call);
  void attributes();
  std::vector<ExprPtr> expressionList();
  static ExprPtr make(ExprKind kind, int line, std::string text = {});
  // Adds a kid; one that would make the expression too high becomes unknown.
  void adopt(Expr& parent, ExprPtr kid);

  // Types: read and forgotten.
  void type();
  void typeAtom();
  void namedType();
  void tableType();
  void functionType();
  void typeOrPack();
  void typeArguments();
  void annotation() {
    if (accept(":")) type();
  }
  void instantiation();
  void generics();  // <T, U..., V = default>, if there is a list

  // Errors: the first one counts.
  void fail(int line, std::string message);
  void failHere(std::string_view expected);  // "expected X, found Y"
  std::string found() const;

  // Tokens.
  const Token& peek(size_t ahead = 0) const {
    return tokens_[position_ + ahead < tokens_.size() ? position_ + ahead : tokens_.size() - 1];
  }
  const Token& next() {
    const Token& token = peek();
    if (token.error) fail(token.line, token.error);
    if (position_ + 1 < tokens_.size()) ++position_;
    return token;
  }
  bool atEnd() const { return peek().kind == TokenKind::end; }
  int lineBefore() const { return tokens_[position_ > 0 ? position_ - 1 : 0].line; }
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
  // The counterpart of what was opened: the error tells where that was.
  void close(std::string_view symbol, std::string_view opener, int line);
  void closeKeyword(std::string_view keyword, std::string_view opener, int line);
  std::string nameToken();

  std::vector<Token> tokens_;
  size_t position_ = 0;
  int depth_ = 0;
  Surroundings around_;
  bool broken_ = false;
  std::string error_;
  int errorLine_ = 0;
};

inline StatPtr makeStat(StatKind kind, int line) {
  auto stat = std::make_unique<Stat>();
  stat->kind = kind;
  stat->line = line;
  stat->endLine = line;
  return stat;
}

}  // namespace obby::luau
