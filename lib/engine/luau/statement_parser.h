// Parses statements. Loops are in loop_parser.cpp.
#pragma once

#include "engine/luau/expression_parser.h"

namespace obby::luau {

class StatementParser final : private ExpressionParser {
 public:
  using ExpressionParser::ExpressionParser;

  Chunk chunk();

 private:
  Block block() override;
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
  bool continuesName() const;  // true if the tokens after a name make it an expression
};

inline StatPtr makeStat(StatKind kind, int line) {
  auto stat = std::make_unique<Stat>();
  stat->kind = kind;
  stat->line = line;
  stat->endLine = line;
  return stat;
}

}  // namespace obby::luau
