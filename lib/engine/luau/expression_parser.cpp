// Expressions of the Luau parser: precedence climbing, calls, tables, functions; types are skipped.
#include <algorithm>

#include "engine/luau/parser_state.h"

namespace obby::luau {
namespace {

// How tightly a binary operator binds, left and right; 0: no operator.
struct Binding {
  int left, right;
};

Binding bindingOf(const Token& token) {
  const std::string& t = token.text;
  if (token.kind == TokenKind::keyword) {
    if (t == "or") return {1, 2};
    if (t == "and") return {3, 4};
    return {0, 0};
  }
  if (token.kind != TokenKind::symbol) return {0, 0};
  if (t == "<" || t == ">" || t == "<=" || t == ">=" || t == "==" || t == "~=") return {5, 6};
  if (t == "..") return {8, 7};
  if (t == "+" || t == "-") return {9, 10};
  if (t == "*" || t == "/" || t == "//" || t == "%") return {11, 12};
  if (t == "^") return {16, 15};
  return {0, 0};
}
constexpr int kUnaryBinding = 13;

}  // namespace

ExprPtr Parser::make(ExprKind kind, std::string text) const {
  auto expr = std::make_unique<Expr>();
  expr->kind = kind;
  expr->line = peek().line;
  expr->text = std::move(text);
  return expr;
}

void Parser::adopt(Expr& parent, ExprPtr kid) {
  if (kid->height >= kMaxHeight) {
    broken_ = true;
    kid = make(ExprKind::unknown);
  }
  parent.height = std::max(parent.height, kid->height + 1);
  parent.kids.push_back(std::move(kid));
}

std::vector<ExprPtr> Parser::expressionList() {
  std::vector<ExprPtr> list;
  do list.push_back(expression());
  while (accept(","));
  return list;
}

ExprPtr Parser::expression(int least) {
  const Depth depth(*this);
  if (depth.tooDeep()) {
    broken_ = true;
    next();
    return make(ExprKind::unknown);
  }
  ExprPtr left = unary();
  for (;;) {
    const Binding binding = bindingOf(peek());
    if (binding.left == 0 || binding.left < least) return left;
    auto binary = make(ExprKind::binary, next().text);
    adopt(*binary, std::move(left));
    adopt(*binary, expression(binding.right));
    left = std::move(binary);
  }
}

ExprPtr Parser::unary() {
  if (isSymbol("-") || isSymbol("#") || isKeyword("not")) {
    auto unary = make(ExprKind::unary, next().text);
    adopt(*unary, expression(kUnaryBinding));
    return unary;
  }
  ExprPtr value = simple();
  while (accept("::")) skipType();
  return value;
}

ExprPtr Parser::simple() {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::number: {
      auto expr = make(ExprKind::number);
      expr->number = next().number;
      return expr;
    }
    case TokenKind::keyword:
      if (acceptKeyword("nil")) return make(ExprKind::nil);
      if (acceptKeyword("true")) return make(ExprKind::truth);
      if (acceptKeyword("false")) return make(ExprKind::falsehood);
      if (acceptKeyword("function")) return functionBody(token.line);
      if (acceptKeyword("if")) return choice();
      break;
    case TokenKind::symbol:
      if (accept("...")) return make(ExprKind::vararg);
      break;
    default: break;
  }
  if (auto value = primary()) return value;
  broken_ = true;
  return make(ExprKind::unknown);
}

ExprPtr Parser::primary() {
  const Token& token = peek();
  if (token.kind == TokenKind::name) return suffixes(make(ExprKind::name, next().text));
  if (token.kind == TokenKind::string) return suffixes(literal());
  if (isSymbol("{")) return suffixes(table());
  if (accept("(")) {
    auto inner = expression();
    expect(")");
    return suffixes(std::move(inner));
  }
  return nullptr;
}

ExprPtr Parser::literal() {
  const Token& token = next();
  auto expr = make(ExprKind::string, token.text);
  expr->known = token.known;
  return expr;
}

ExprPtr Parser::suffixes(ExprPtr from) {
  for (;;) {
    ExprPtr outer;
    if (accept(".")) {
      outer = make(ExprKind::field, nameToken());
      adopt(*outer, std::move(from));
    } else if (accept("[")) {
      outer = make(ExprKind::index);
      adopt(*outer, std::move(from));
      adopt(*outer, expression());
      expect("]");
    } else if (isSymbol(":") && peek(1).kind == TokenKind::name) {
      next();
      outer = make(ExprKind::method, nameToken());
      adopt(*outer, std::move(from));
      arguments(*outer);
    } else if (isSymbol("(") || isSymbol("{") || peek().kind == TokenKind::string) {
      // A literal is not called: `x = "a" (f or g)()` does not occur, `"a" {` does in tables.
      if (from->kind == ExprKind::string || from->kind == ExprKind::table) return from;
      outer = make(ExprKind::call);
      adopt(*outer, std::move(from));
      arguments(*outer);
    } else {
      return from;
    }
    from = std::move(outer);
  }
}

void Parser::arguments(Expr& call) {
  if (peek().kind == TokenKind::string) {
    adopt(call, literal());
  } else if (isSymbol("{")) {
    adopt(call, table());
  } else if (accept("(")) {
    if (accept(")")) return;
    for (auto& argument : expressionList()) adopt(call, std::move(argument));
    expect(")");
  } else {
    broken_ = true;
  }
}

ExprPtr Parser::table() {
  auto expr = make(ExprKind::table);
  accept("{");
  while (!atEnd() && !isSymbol("}")) {
    const size_t before = position_;
    ExprPtr key;
    if (peek().kind == TokenKind::name && peek(1).kind == TokenKind::symbol &&
        peek(1).text == "=") {
      key = make(ExprKind::string, next().text);
      next();
    } else if (accept("[")) {
      key = expression();
      expect("]");
      expect("=");
    }
    expr->keys.push_back(std::move(key));
    adopt(*expr, expression());
    if (!accept(",")) accept(";");
    if (position_ == before) next();
  }
  expect("}");
  return expr;
}

ExprPtr Parser::choice() {
  const Depth depth(*this);
  auto expr = make(ExprKind::choice);
  if (depth.tooDeep()) {
    broken_ = true;
    return make(ExprKind::unknown);
  }
  adopt(*expr, expression());
  expectKeyword("then");
  adopt(*expr, expression());
  if (acceptKeyword("elseif")) {
    adopt(*expr, choice());
    return expr;
  }
  expectKeyword("else");
  adopt(*expr, expression());
  return expr;
}

ExprPtr Parser::functionBody(int line) {
  auto expr = make(ExprKind::function);
  expr->line = line;
  expr->body = std::make_unique<Function>();
  expr->body->line = line;
  if (accept("<")) skipUntil(">");
  expect("(");
  while (!atEnd() && !isSymbol(")")) {
    if (!accept("...")) expr->body->parameters.push_back(nameToken());
    if (accept(":")) skipType();
    if (!accept(",") && !isSymbol(")")) {
      broken_ = true;
      break;
    }
  }
  expect(")");
  if (accept(":")) skipType();
  expr->body->body = block();
  expectKeyword("end");
  return expr;
}

void Parser::skipUntil(std::string_view symbol) {
  while (!atEnd() && !accept(symbol)) next();
}

void Parser::skipTypeAtom() {
  const auto skipPair = [&](std::string_view open, std::string_view close) {
    int depth = 0;
    do {
      if (isSymbol(open)) ++depth;
      if (isSymbol(close)) --depth;
      next();
    } while (!atEnd() && depth > 0);
  };
  while (accept("...")) {
  }
  if (isSymbol("{")) return skipPair("{", "}");
  if (isSymbol("(")) return skipPair("(", ")");
  if (peek().kind == TokenKind::string || isKeyword("nil") || isKeyword("true") ||
      isKeyword("false")) {
    next();
    return;
  }
  nameToken();
  while (accept(".")) nameToken();
  if (isSymbol("(")) skipPair("(", ")");  // typeof(x)
  if (isSymbol("<")) skipPair("<", ">");
}

void Parser::skipType() {
  do {
    skipTypeAtom();
    while (accept("?")) {
    }
  } while (accept("|") || accept("&") || accept("->"));
}

}  // namespace obby::luau
