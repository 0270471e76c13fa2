// Emits operators and if-expressions. Operators that Lua 5.1 lacks, or handles differently, become
// calls of helpers.
#include "engine/luau/expression_emitter.h"

namespace obby::luau {
namespace {

bool isCertainlyTrue(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::truth:
    case ExprKind::number:
    case ExprKind::string:
    case ExprKind::function:
    case ExprKind::table: return true;
    default: return false;
  }
}

bool isConcatenation(const Expr& expr) {
  return expr.kind == ExprKind::binary && expr.text == "..";
}

}  // namespace

std::vector<const Expr*> concatenated(const Expr& expr) {
  std::vector<const Expr*> operands;
  const Expr* at = &expr;
  for (; isConcatenation(*at) && (at == &expr || !at->parenthesised); at = at->kids[1].get())
    operands.push_back(at->kids[0].get());
  operands.push_back(at);
  return operands;
}

void ExpressionEmitter::unary(const Expr& expr) {
  const Expr& operand = *expr.kids[0];
  if (expr.text == "not") {
    keyword("not");
    return expression(operand);
  }
  if (expr.text == "#") {
    helper("len");
    single(operand);
    return out_.symbol(")");
  }
  out_.symbol("-");
  // 5.1 has one constant for 0 and -0.
  if (operand.kind != ExprKind::number || operand.number != 0) return expression(operand);
  out_.word(prefix_);
  out_.symbol(".zero");
}

void ExpressionEmitter::binary(const Expr& expr) {
  if (expr.text == "..") return concatenation(concatenated(expr));
  if (expr.text == "//") return quotient(*expr.kids[0], *expr.kids[1]);
  expression(*expr.kids[0]);
  if (expr.text == "and" || expr.text == "or")
    keyword(expr.text);
  else
    out_.symbol(expr.text);
  expression(*expr.kids[1]);
}

void ExpressionEmitter::quotient(const Expr& left, const Expr& right) {
  helper("idiv");
  single(left);
  out_.symbol(",");
  single(right);
  out_.symbol(")");
}

void ExpressionEmitter::concatenation(const std::vector<const Expr*>& operands) {
  const bool many = operands.size() > kMaxArguments;
  helper(many ? "catn" : "cat");
  if (many) out_.symbol(std::to_string(operands.size()) + ",{");
  for (size_t i = 0; i < operands.size(); ++i) {
    if (i > 0) out_.symbol(",");
    single(*operands[i]);
  }
  out_.symbol(many ? "})" : ")");
}

void ExpressionEmitter::condition(const Expr& expr) {
  if (expr.kind == ExprKind::binary)
    bracketed(expr);
  else
    expression(expr);
}

// Emits (c and a or b) if a is certainly true; otherwise (c and {a} or {b})[1]. A table is true
// whatever it holds. Unlike a function it needs no upvalues, no `...` and no level of calls.
void ExpressionEmitter::choice(const Expr& expr) {
  bool plain = true;
  for (const Expr* at = &expr; at->kind == ExprKind::choice; at = at->kids[2].get())
    plain = plain && isCertainlyTrue(*at->kids[1]);
  const auto value = [&](const Expr& of) {
    out_.symbol(plain ? "(" : "{");
    single(of);
    out_.symbol(plain ? ")" : "}");
  };
  out_.symbol("(");
  const Expr* at = &expr;
  for (; at == &expr || (at->kind == ExprKind::choice && !at->parenthesised);
       at = at->kids[2].get()) {
    condition(*at->kids[0]);
    keyword("and");
    value(*at->kids[1]);
    keyword("or");
  }
  value(*at);
  out_.symbol(plain ? ")" : ")[1]");
}

}  // namespace obby::luau
