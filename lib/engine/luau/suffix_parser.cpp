// Parses expressions that begin with a name or a bracket (fields, calls and tables), and strings.
#include <utility>

#include "engine/luau/expression_parser.h"

namespace obby::luau {

ExprPtr ExpressionParser::primary() {
  const int line = peek().line;
  if (peek().kind == TokenKind::name) return suffixes(make(ExprKind::name, line, next().text));
  if (!accept("(")) return nullptr;
  auto inner = expression();
  close(")", "(", line);
  inner->parenthesised = true;
  return suffixes(std::move(inner));
}

ExprPtr ExpressionParser::stringLiteral() {
  const Token& token = next();
  return make(ExprKind::string, token.line, token.text);
}

ExprPtr ExpressionParser::interpolated() {
  const bool expressions = peek().opens;
  ExprPtr expr = stringLiteral();
  if (!expressions) return expr;
  expr->known = false;
  auto part = make(ExprKind::string, expr->line, std::exchange(expr->text, {}));
  for (;;) {
    expr->keys.push_back(std::move(part));
    if (peek().kind == TokenKind::continuation) failHere("an expression inside '{}'");
    adopt(*expr, expression());
    if (peek().kind != TokenKind::continuation) {
      failHere("'}' to continue the string that starts on line " + std::to_string(expr->line));
      expr->keys.push_back(make(ExprKind::string, expr->line));
      return expr;
    }
    const bool opens = peek().opens;
    part = stringLiteral();
    if (!opens) break;
  }
  expr->keys.push_back(std::move(part));
  return expr;
}

ExprPtr ExpressionParser::suffixes(ExprPtr from) {
  while (auto outer = suffix(from)) from = std::move(outer);
  return from;
}

ExprPtr ExpressionParser::suffix(ExprPtr& from) {
  const int line = peek().line;
  ExprPtr outer;
  if (accept(".")) {
    outer = make(ExprKind::field, peek().line);
    outer->text = nameToken();
    adopt(*outer, std::move(from));
  } else if (accept("[")) {
    outer = make(ExprKind::index, line);
    adopt(*outer, std::move(from));
    adopt(*outer, expression());
    close("]", "[", line);
  } else if (accept(":")) {
    outer = make(ExprKind::method, peek().line);
    outer->text = nameToken();
    adopt(*outer, std::move(from));
    instantiation();
    arguments(*outer);
  } else if (isSymbol("(") || isSymbol("{") || peek().kind == TokenKind::string) {
    outer = make(ExprKind::call, line);
    adopt(*outer, std::move(from));
    arguments(*outer);
  } else if (isSymbol("<") && isSymbol(peek(1), "<")) {
    instantiation();
    return std::move(from);
  }
  return outer;
}

void ExpressionParser::arguments(Expr& call) {
  const int line = peek().line;
  if (peek().kind == TokenKind::string) {
    adopt(call, stringLiteral());
  } else if (isSymbol("{")) {
    adopt(call, table());
  } else if (isSymbol("(")) {
    if (line != lineBefore())
      fail(line,
           "'(' on a new line could begin a statement or a call: put ';' before it to begin a "
           "statement");
    next();
    if (accept(")")) return;
    for (auto& argument : expressionList()) adopt(call, std::move(argument));
    close(")", "(", line);
  } else {
    failHere("'(', '{' or a string as the arguments of a call");
  }
}

ExprPtr ExpressionParser::table() {
  const int line = next().line;
  auto expr = make(ExprKind::table, line);
  while (!atEnd() && !isSymbol("}")) {
    const size_t before = position();
    expr->keys.push_back(tableKey());
    adopt(*expr, expression());
    if (!accept(",") && !accept(";") && !isSymbol("}")) {
      close("}", "{", line);  // reports an error
      if (position() == before) next();
    }
  }
  close("}", "{", line);
  return expr;
}

ExprPtr ExpressionParser::tableKey() {
  const int line = peek().line;
  if (peek().kind == TokenKind::name && isSymbol(peek(1), "=")) {
    auto key = stringLiteral();
    next();
    return key;
  }
  if (!accept("[")) return nullptr;
  auto key = expression();
  close("]", "[", line);
  expect("=");
  return key;
}

}  // namespace obby::luau
