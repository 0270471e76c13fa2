// Parses expressions: precedence climbing, literals, functions.
#include <algorithm>
#include <utility>

#include "engine/luau/expression_parser.h"

namespace obby::luau {
namespace {

// The left and right precedence of a binary operator; 0: no operator.
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
constexpr int kAboveConcatenation = 9;

}  // namespace

ExprPtr ExpressionParser::make(ExprKind kind, int line, std::string text) {
  auto expr = std::make_unique<Expr>();
  expr->kind = kind;
  expr->line = line;
  expr->text = std::move(text);
  return expr;
}

void ExpressionParser::adopt(Expr& parent, ExprPtr kid) {
  if (kid->height >= kMaxHeight) {
    fail(parent.line, "this expression is too long");
    kid = make(ExprKind::unknown, parent.line);
  }
  parent.height = std::max(parent.height, kid->height + 1);
  parent.kids.push_back(std::move(kid));
}

std::vector<ExprPtr> ExpressionParser::expressionList() {
  std::vector<ExprPtr> list;
  do list.push_back(expression());
  while (accept(","));
  return list;
}

ExprPtr ExpressionParser::expression(int minBinding) {
  const Depth depth(*this);
  if (depth.tooDeep()) return make(ExprKind::unknown, peek().line);
  ExprPtr left = unary();
  for (;;) {
    const Binding binding = bindingOf(peek());
    if (binding.left == 0 || binding.left < minBinding) return left;
    if (peek().text == "..") {
      left = concatenation(std::move(left));
      continue;
    }
    const Token& op = next();
    auto binary = make(ExprKind::binary, op.line, op.text);
    adopt(*binary, std::move(left));
    adopt(*binary, expression(binding.right));
    left = std::move(binary);
  }
}

// Parses a chain of the right associative operator `..`. Chains may be long, so they add no depth.
ExprPtr ExpressionParser::concatenation(ExprPtr first) {
  std::vector<ExprPtr> operands;
  std::vector<int> lines;
  operands.push_back(std::move(first));
  while (isSymbol("..")) {
    lines.push_back(next().line);
    operands.push_back(expression(kAboveConcatenation));
  }
  ExprPtr right = std::move(operands.back());
  for (size_t i = lines.size(); i-- > 0;) {
    auto binary = make(ExprKind::binary, lines[i], "..");
    adopt(*binary, std::move(operands[i]));
    adopt(*binary, std::move(right));
    right = std::move(binary);
  }
  return right;
}

ExprPtr ExpressionParser::unary() {
  if (isSymbol("-") || isSymbol("#") || isKeyword("not")) {
    const Token& op = next();
    auto unary = make(ExprKind::unary, op.line, op.text);
    adopt(*unary, expression(kUnaryBinding));
    return unary;
  }
  ExprPtr value = simple();
  while (accept("::")) {
    type();
    const ExprKind kind = value->kind;
    if (kind == ExprKind::call || kind == ExprKind::method || kind == ExprKind::vararg)
      value->parenthesised = true;
  }
  return value;
}

ExprPtr ExpressionParser::simple() {
  const Token& token = peek();
  const int line = token.line;
  ExprPtr value;
  switch (token.kind) {
    case TokenKind::number:
      value = make(ExprKind::number, line, token.text);
      value->number = next().number;
      return value;
    case TokenKind::string: return stringLiteral();
    case TokenKind::interpolation: return interpolated();
    case TokenKind::keyword: value = keywordValue(); break;
    case TokenKind::symbol:
      if (isSymbol("...")) return vararg();
      if (isSymbol("{")) return table();
      if (isSymbol("@")) {
        attributes();
        if (isKeyword("function")) value = keywordValue();
      } else {
        value = primary();
      }
      break;
    default: value = primary();
  }
  if (value) return value;
  failHere("an expression");
  return make(ExprKind::unknown, line);
}

ExprPtr ExpressionParser::keywordValue() {
  const int line = peek().line;
  if (acceptKeyword("nil")) return make(ExprKind::nil, line);
  if (acceptKeyword("true")) return make(ExprKind::truth, line);
  if (acceptKeyword("false")) return make(ExprKind::falsehood, line);
  if (acceptKeyword("function")) return functionBody(line);
  if (acceptKeyword("if")) return choice();
  return nullptr;
}

ExprPtr ExpressionParser::vararg() {
  const int line = next().line;
  if (!around_.vararg) fail(line, "'...' is used in a function that does not take it");
  return make(ExprKind::vararg, line);
}

ExprPtr ExpressionParser::choice() {
  const Depth depth(*this);
  const int line = lineBefore();
  if (depth.tooDeep()) return make(ExprKind::unknown, line);
  auto expr = make(ExprKind::choice, line);
  adopt(*expr, expression());
  expectKeyword("then");
  adopt(*expr, expression());
  if (acceptKeyword("elseif")) {
    adopt(*expr, choice());
    return expr;
  }
  if (!acceptKeyword("else")) failHere("'else' of the 'if' expression");
  adopt(*expr, expression());
  return expr;
}

ExprPtr ExpressionParser::functionBody(int line) {
  auto expr = make(ExprKind::function, line);
  expr->body = std::make_unique<Function>();
  Function& function = *expr->body;
  function.line = line;
  generics();
  parameters(function);
  if (accept(":")) typeOrPack();
  const Surroundings outer = std::exchange(around_, {function.vararg, 0});
  function.body = block();
  around_ = outer;
  function.endLine = peek().line;
  closeKeyword("end", "function", line);
  return expr;
}

void ExpressionParser::parameters(Function& function) {
  const int line = peek().line;
  expect("(");
  while (!isSymbol(")")) {
    if (accept("...")) {
      function.vararg = true;
      if (accept(":")) typeOrPack();
      break;
    }
    function.parameters.push_back(nameToken());
    annotation();
    if (!accept(",")) break;
    if (isSymbol(")")) failHere("a parameter");
  }
  close(")", "(", line);
}

void ExpressionParser::attributes() {
  while (accept("@")) {
    if (!accept("[")) {
      nameToken();
      continue;
    }
    do {
      nameToken();
      if (isSymbol("(") || isSymbol("{") || peek().kind == TokenKind::string) {
        auto call = make(ExprKind::call, peek().line);
        arguments(*call);
      }
    } while (accept(","));
    expect("]");
  }
}

}  // namespace obby::luau
