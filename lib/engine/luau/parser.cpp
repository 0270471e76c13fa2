// Parses statements by recursive descent. Loops are in loop_parser.cpp, expressions in
// expression_parser.cpp.
#include "engine/luau/parser.h"

#include <utility>

#include "engine/luau/statement_parser.h"

namespace obby::luau {
namespace {

bool isAssignmentOperator(const Token& token) {
  static constexpr std::string_view kOperators[] = {
      "+=", "-=", "*=", "/=", "%=", "^=", "..=", "//="};
  if (token.kind != TokenKind::symbol || token.text.back() != '=') return false;
  for (std::string_view op : kOperators)
    if (token.text == op) return true;
  return false;
}

}  // namespace

Block StatementParser::block() {
  Block statements;
  const Depth depth(*this);
  while (!atEnd() && !blockEnds()) {
    const size_t before = position();
    StatPtr stat = depth.tooDeep() ? nullptr : statement();
    accept(";");
    if (stat) {
      checkLast(*stat);
      statements.push_back(std::move(stat));
    }
    if (position() == before) {  // no statement begins here
      failHere("a statement");
      next();
    }
  }
  return statements;
}

bool StatementParser::blockEnds() const {
  if (peek().kind != TokenKind::keyword) return false;
  return isKeyword("end") || isKeyword("else") || isKeyword("elseif") || isKeyword("until");
}

void StatementParser::checkLast(const Stat& stat) {
  const bool last = stat.kind == StatKind::returns || stat.kind == StatKind::leaves;
  if (!last || atEnd() || blockEnds()) return;
  failHere("the end of the block after '" +
           (stat.kind == StatKind::returns ? "return" : stat.text) + "'");
}

StatPtr StatementParser::statement() {
  const int line = peek().line;
  if (peek().kind == TokenKind::keyword) return keywordStatement(line);
  if (isSymbol("@")) return attributed(line);
  if (peek().kind == TokenKind::name)
    if (auto stat = contextualStatement(line)) return stat;
  return callOrAssignment(line);
}

StatPtr StatementParser::keywordStatement(int line) {
  if (acceptKeyword("local")) {
    if (acceptKeyword("function")) return localFunction(line);
    return local(line, "");
  }
  if (acceptKeyword("if")) return branch(line);
  if (acceptKeyword("function")) return namedFunction(line);
  if (acceptKeyword("return")) return returns(line);
  if (acceptKeyword("for")) return forLoop(line);
  if (acceptKeyword("while")) return whileLoop(line);
  if (acceptKeyword("repeat")) return repeatLoop(line);
  if (acceptKeyword("do")) return doBlock(line);
  if (isKeyword("break")) return leaves(line);
  return nullptr;
}

StatPtr StatementParser::contextualStatement(int line) {
  const Token& after = peek(1);
  const bool name = after.kind == TokenKind::name;
  const bool function = after.kind == TokenKind::keyword && after.text == "function";
  if (isName("continue") && !continuesName()) return leaves(line);
  if (isName("type") && (name || function)) return typeDeclaration(line);
  if (isName("export") && name && after.text == "type") {
    next();
    return typeDeclaration(line);
  }
  if (!isName("const") || !(name || function)) return nullptr;
  next();
  if (acceptKeyword("function")) return localFunction(line);
  return local(line, "const");
}

bool StatementParser::continuesName() const {
  const Token& after = peek(1);
  if (after.kind == TokenKind::string || after.kind == TokenKind::interpolation) return true;
  if (after.kind != TokenKind::symbol) return false;
  static constexpr std::string_view kSymbols[] = {"=", "(", ".", ":", "[", "{", ",", "<"};
  for (std::string_view symbol : kSymbols)
    if (after.text == symbol) return true;
  return isAssignmentOperator(after);
}

StatPtr StatementParser::local(int line, const char* text) {
  auto stat = makeStat(StatKind::local, line);
  stat->text = text;
  do {
    stat->names.push_back(nameToken());
    annotation();
  } while (accept(","));
  if (accept("="))
    stat->values = expressionList();
  else if (!stat->text.empty())
    failHere("'=' and the value of a constant");
  return stat;
}

StatPtr StatementParser::localFunction(int line) {
  auto stat = makeStat(StatKind::function, line);
  stat->names.push_back(nameToken());
  stat->values.push_back(functionBody(line));
  return stat;
}

StatPtr StatementParser::attributed(int line) {
  attributes();
  if (isKeyword("local") || isName("const"))
    next();
  else if (acceptKeyword("function"))
    return namedFunction(line);
  if (acceptKeyword("function")) return localFunction(line);
  failHere("'function' after an attribute");
  return nullptr;
}

StatPtr StatementParser::doBlock(int line) {
  auto stat = makeStat(StatKind::block, line);
  stat->blocks.push_back(block());
  stat->endLine = peek().line;
  closeKeyword("end", "do", line);
  return stat;
}

StatPtr StatementParser::branch(int line) {
  auto stat = makeStat(StatKind::branch, line);
  do {
    stat->values.push_back(expression());
    expectKeyword("then");
    stat->blocks.push_back(block());
  } while (acceptKeyword("elseif"));
  if (acceptKeyword("else")) stat->blocks.push_back(block());
  stat->endLine = peek().line;
  closeKeyword("end", "if", line);
  return stat;
}

StatPtr StatementParser::returns(int line) {
  auto stat = makeStat(StatKind::returns, line);
  if (!atEnd() && !blockEnds() && !isSymbol(";")) stat->values = expressionList();
  return stat;
}

StatPtr StatementParser::leaves(int line) {
  auto stat = makeStat(StatKind::leaves, line);
  stat->text = next().text;
  if (around_.loops == 0) fail(line, "'" + stat->text + "' outside of a loop");
  return stat;
}

StatPtr StatementParser::namedFunction(int line) {
  auto stat = makeStat(StatKind::function, line);
  const int start = peek().line;
  auto target = make(ExprKind::name, start, nameToken());
  bool method = false;
  while (!method && (isSymbol(".") || isSymbol(":"))) {
    method = next().text == ":";
    const int at = peek().line;
    auto field = make(ExprKind::field, at, nameToken());
    adopt(*field, std::move(target));
    target = std::move(field);
  }
  stat->targets.push_back(std::move(target));
  auto function = functionBody(line);
  if (method) function->body->parameters.insert(function->body->parameters.begin(), "self");
  stat->values.push_back(std::move(function));
  return stat;
}

StatPtr StatementParser::typeDeclaration(int line) {
  next();
  if (acceptKeyword("function")) {
    nameToken();
    functionBody(line);
  } else {
    nameToken();
    generics();
    expect("=");
    type();
  }
  return makeStat(StatKind::block, line);
}

StatPtr StatementParser::callOrAssignment(int line) {
  const size_t before = position();
  auto first = primary();
  if (!first) return nullptr;
  if (isSymbol("=") || isSymbol(",")) return assignment(line, std::move(first));
  if (isAssignmentOperator(peek())) {
    auto stat = makeStat(StatKind::compound, line);
    checkTarget(*first);
    stat->text = next().text;
    stat->text.pop_back();
    stat->targets.push_back(std::move(first));
    stat->values.push_back(expression());
    return stat;
  }
  const bool call = first->kind == ExprKind::call || first->kind == ExprKind::method;
  if (!call || first->parenthesised) {
    fail(line, "incomplete statement: expected an assignment or a call, found " + found());
    if (position() == before) return nullptr;
  }
  auto stat = makeStat(StatKind::call, line);
  stat->values.push_back(std::move(first));
  return stat;
}

StatPtr StatementParser::assignment(int line, ExprPtr first) {
  auto stat = makeStat(StatKind::assign, line);
  checkTarget(*first);
  stat->targets.push_back(std::move(first));
  while (accept(",")) {
    auto target = primary();
    if (!target) {
      failHere("a variable or a field");
      continue;
    }
    checkTarget(*target);
    stat->targets.push_back(std::move(target));
  }
  expect("=");
  stat->values = expressionList();
  return stat;
}

void StatementParser::checkTarget(const Expr& target) {
  const bool assignable = target.kind == ExprKind::name || target.kind == ExprKind::field ||
                          target.kind == ExprKind::index;
  if (!assignable || target.parenthesised)
    fail(target.line, "only a variable or a field can be assigned to");
}

Chunk StatementParser::chunk() {
  Chunk chunk;
  while (!atEnd()) {  // a stray `end` ends a block early; continue after it
    Block more = block();
    for (auto& stat : more) chunk.body.push_back(std::move(stat));
    if (atEnd()) break;
    failHere("'<end of file>'");
    next();
  }
  chunk.broken = isBroken();
  chunk.error = error();
  chunk.errorLine = errorLine();
  return chunk;
}

Chunk parse(std::string_view source) { return StatementParser(source).chunk(); }

}  // namespace obby::luau
