// Parses expressions. Operators and functions are in expression_parser.cpp; expressions that begin
// with a name or a bracket are in suffix_parser.cpp.
#pragma once

#include <string>
#include <vector>

#include "engine/luau/type_parser.h"

namespace obby::luau {

class ExpressionParser : protected TypeParser {
 protected:
  using TypeParser::TypeParser;

  static constexpr int kMaxHeight = 1000;  // height of one expression
  // The targets that `...`, `break` and `continue` may refer to.
  struct Surroundings {
    bool vararg = true;
    int loops = 0;
  };

  virtual Block block() = 0;  // parses the statements of a function

  ExprPtr expression(int minBinding = 0) override;
  ExprPtr concatenation(ExprPtr first);
  ExprPtr unary();
  ExprPtr simple();
  ExprPtr keywordValue();  // null if no value keyword begins here
  ExprPtr vararg();
  ExprPtr primary();  // null if no expression begins here
  ExprPtr stringLiteral();
  ExprPtr interpolated();
  ExprPtr suffixes(ExprPtr from);
  ExprPtr suffix(ExprPtr& from);  // null if no suffix begins here
  ExprPtr table();
  ExprPtr tableKey();  // null for a positional item
  ExprPtr choice();
  ExprPtr functionBody(int line);
  void parameters(Function& function);
  void arguments(Expr& call);
  void attributes();
  std::vector<ExprPtr> expressionList();
  static ExprPtr make(ExprKind kind, int line, std::string text = {});
  // Adds a kid. If the expression would become too high, the kid becomes unknown.
  void adopt(Expr& parent, ExprPtr kid);

  Surroundings around_;
};

}  // namespace obby::luau
