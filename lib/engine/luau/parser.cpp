// Recursive descent over statements; expressions are in expression_parser.cpp.
#include "engine/luau/parser.h"

#include "engine/luau/parser_state.h"

namespace obby::luau {
namespace {

bool isAssignmentOperator(const Token& token) {
  static constexpr std::string_view kOperators[] = {
      "+=", "-=", "*=", "/=", "%=", "^=", "..=", "//="};
  if (token.kind != TokenKind::symbol) return false;
  for (std::string_view op : kOperators)
    if (token.text == op) return true;
  return false;
}

StatPtr makeStat(StatKind kind, int line) {
  auto stat = std::make_unique<Stat>();
  stat->kind = kind;
  stat->line = line;
  return stat;
}

}  // namespace

Block Parser::block() {
  Block statements;
  const Depth depth(*this);
  while (!atEnd() && !blockEnds()) {
    const size_t before = position_;
    if (accept(";")) continue;
    StatPtr stat = depth.tooDeep() ? nullptr : statement();
    if (stat) statements.push_back(std::move(stat));
    if (position_ == before) {  // no statement begins here
      broken_ = true;
      next();
    }
  }
  return statements;
}

bool Parser::blockEnds() const {
  return isKeyword("end") || isKeyword("else") || isKeyword("elseif") || isKeyword("until");
}

StatPtr Parser::statement() {
  const int line = peek().line;
  if (acceptKeyword("local")) return local(line);
  if (acceptKeyword("if")) return branch(line);
  if (acceptKeyword("while")) {
    auto stat = makeStat(StatKind::whileLoop, line);
    stat->values.push_back(expression());
    expectKeyword("do");
    stat->blocks.push_back(block());
    expectKeyword("end");
    return stat;
  }
  if (acceptKeyword("do")) {
    auto stat = makeStat(StatKind::block, line);
    stat->blocks.push_back(block());
    expectKeyword("end");
    return stat;
  }
  if (acceptKeyword("for")) return loop(line);
  if (acceptKeyword("repeat")) {
    auto stat = makeStat(StatKind::repeatLoop, line);
    stat->blocks.push_back(block());
    expectKeyword("until");
    stat->values.push_back(expression());
    return stat;
  }
  if (acceptKeyword("function")) return namedFunction(line);
  if (acceptKeyword("return")) {
    auto stat = makeStat(StatKind::returns, line);
    if (!atEnd() && !blockEnds() && !isSymbol(";")) stat->values = expressionList();
    return stat;
  }
  if (isKeyword("break") || (isName("continue") && !isCallOrAssignmentAhead())) {
    auto stat = makeStat(StatKind::leaves, line);
    stat->text = next().text;
    return stat;
  }
  if ((isName("type") || isName("export")) && peek(1).kind == TokenKind::name)
    return typeDeclaration();
  return callOrAssignment(line);
}

StatPtr Parser::local(int line) {
  if (acceptKeyword("function")) {
    auto stat = makeStat(StatKind::function, line);
    stat->names.push_back(nameToken());
    stat->values.push_back(functionBody(line));
    return stat;
  }
  auto stat = makeStat(StatKind::local, line);
  do {
    stat->names.push_back(nameToken());
    if (accept("<")) {  // attribute
      nameToken();
      accept(">");
    }
    if (accept(":")) skipType();
  } while (accept(","));
  if (accept("=")) stat->values = expressionList();
  return stat;
}

StatPtr Parser::branch(int line) {
  auto stat = makeStat(StatKind::branch, line);
  do {
    stat->values.push_back(expression());
    expectKeyword("then");
    stat->blocks.push_back(block());
  } while (acceptKeyword("elseif"));
  if (acceptKeyword("else")) stat->blocks.push_back(block());
  expectKeyword("end");
  return stat;
}

StatPtr Parser::loop(int line) {
  auto stat = makeStat(StatKind::genericFor, line);
  do {
    stat->names.push_back(nameToken());
    if (accept(":")) skipType();
  } while (accept(","));
  if (accept("=")) {
    stat->kind = StatKind::numericFor;
    stat->values = expressionList();
  } else {
    expectKeyword("in");
    stat->values = expressionList();
  }
  expectKeyword("do");
  stat->blocks.push_back(block());
  expectKeyword("end");
  return stat;
}

StatPtr Parser::namedFunction(int line) {
  auto stat = makeStat(StatKind::function, line);
  auto target = make(ExprKind::name, nameToken());
  bool method = false;
  while (isSymbol(".") || isSymbol(":")) {
    method = next().text == ":";
    auto field = make(ExprKind::field, nameToken());
    adopt(*field, std::move(target));
    target = std::move(field);
  }
  stat->targets.push_back(std::move(target));
  auto function = functionBody(line);
  if (method) function->body->parameters.insert(function->body->parameters.begin(), "self");
  stat->values.push_back(std::move(function));
  return stat;
}

StatPtr Parser::typeDeclaration() {
  if (isName("export")) next();
  next();
  nameToken();
  if (accept("<")) skipUntil(">");
  if (accept("=")) skipType();
  return makeStat(StatKind::block, peek().line);
}

bool Parser::isCallOrAssignmentAhead() const {
  const Token& after = peek(1);
  return after.kind == TokenKind::symbol &&
         (after.text == "=" || after.text == "(" || after.text == "." || after.text == ":");
}

StatPtr Parser::callOrAssignment(int line) {
  const size_t before = position_;
  auto first = primary();
  if (!first) return nullptr;
  if (isSymbol("=") || isSymbol(",")) {
    auto stat = makeStat(StatKind::assign, line);
    stat->targets.push_back(std::move(first));
    while (accept(","))
      if (auto target = primary()) stat->targets.push_back(std::move(target));
    if (!accept("=")) broken_ = true;
    stat->values = expressionList();
    return stat;
  }
  if (isAssignmentOperator(peek())) {
    auto stat = makeStat(StatKind::compound, line);
    stat->text = next().text;
    stat->text.pop_back();
    stat->targets.push_back(std::move(first));
    stat->values.push_back(expression());
    return stat;
  }
  if (first->kind != ExprKind::call && first->kind != ExprKind::method) {
    broken_ = true;
    if (position_ == before) return nullptr;
  }
  auto stat = makeStat(StatKind::call, line);
  stat->values.push_back(std::move(first));
  return stat;
}

Chunk parse(std::string_view source) {
  Parser parser(tokenize(source));
  Chunk chunk;
  while (!parser.atEnd()) {  // a stray `end` ends a block early: go on behind it
    Block more = parser.block();
    for (auto& stat : more) chunk.body.push_back(std::move(stat));
    if (!parser.atEnd()) parser.skipStray();
  }
  chunk.broken = parser.broken();
  return chunk;
}

}  // namespace obby::luau
