// Emits names, fields, calls, functions and tables.
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "engine/luau/expression_emitter.h"
#include "engine/luau/literals.h"

namespace obby::luau {
namespace {

bool isPlainName(std::string_view text) {
  static constexpr std::array<std::string_view, 21> kReserved = {
      "and", "break",    "do",     "else", "elseif", "end",   "false",
      "for", "function", "if",     "in",   "local",  "nil",   "not",
      "or",  "repeat",   "return", "then", "true",   "until", "while"};
  const auto isPart = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c));
  };
  if (text.empty() || isDigit(text[0]) || !std::all_of(text.begin(), text.end(), isPart))
    return false;
  return std::find(kReserved.begin(), kReserved.end(), text) == kReserved.end();
}

// Returns true if the expression begins with its own token. Others begin with a subexpression.
bool beginsOnItsLine(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::field:
    case ExprKind::index:
    case ExprKind::call:
    case ExprKind::method:
    case ExprKind::binary: return false;
    default: return true;
  }
}

}  // namespace

void ExpressionEmitter::expression(const Expr& expr) {
  if (!expr.parenthesised) return bare(expr);
  out_.symbol("(");
  bare(expr);
  out_.symbol(")");
}

void ExpressionEmitter::bracketed(const Expr& expr) {
  out_.symbol("(");
  bare(expr);
  out_.symbol(")");
}

void ExpressionEmitter::single(const Expr& expr) {
  if (isMulti(expr))
    bracketed(expr);
  else
    expression(expr);
}

void ExpressionEmitter::bare(const Expr& expr) {
  if (beginsOnItsLine(expr)) out_.at(expr.line);
  switch (expr.kind) {
    case ExprKind::nil: return keyword("nil");
    case ExprKind::truth: return keyword("true");
    case ExprKind::falsehood: return keyword("false");
    case ExprKind::number: return number(expr.number);
    case ExprKind::string: return expr.known ? string(expr.text) : interpolation(expr);
    case ExprKind::name: return name(expr);
    case ExprKind::vararg:
      if (scope_->function->outer) return out_.symbol("...");
      helper("none");
      return out_.symbol(")");
    case ExprKind::field:
      expression(*expr.kids[0]);
      out_.at(expr.line);
      out_.symbol(".");
      return out_.word(expr.text);
    case ExprKind::index:
      expression(*expr.kids[0]);
      out_.symbol("[");
      expression(*expr.kids[1]);
      return out_.symbol("]");
    case ExprKind::call:
    case ExprKind::method: return call(expr);
    case ExprKind::function: keyword("function"); return functionBody(*expr.body);
    case ExprKind::table: return table(expr);
    case ExprKind::unary: return unary(expr);
    case ExprKind::binary: return binary(expr);
    case ExprKind::choice: return choice(expr);
    case ExprKind::unknown: return;  // only in broken chunks
  }
}

void ExpressionEmitter::list(const Exprs& exprs, size_t from) {
  for (size_t i = from; i < exprs.size(); ++i) {
    if (i > from) out_.symbol(",");
    expression(*exprs[i]);
  }
}

void ExpressionEmitter::name(const Expr& expr) {
  const Local* local = scopes_.find(expr);
  if (!local) return out_.word(expr.text);
  if (local->scope->table == 0) return out_.word(variable(expr.text));
  out_.word(own("t" + std::to_string(local->scope->table)));
  out_.symbol(".");
  out_.word(expr.text + "_" + std::to_string(local->index));
}

// Lua 5.1 wants the bracket on the line of the called expression. Only names go before it on new
// lines.
void ExpressionEmitter::call(const Expr& expr) {
  expression(*expr.kids[0]);
  if (expr.kind == ExprKind::method) {
    out_.at(expr.line);
    out_.symbol(":");
    out_.word(expr.text);
  }
  out_.symbol("(");
  list(expr.kids, 1);
  out_.symbol(")");
}

void ExpressionEmitter::functionBody(const Function& function) {
  out_.symbol("(");
  variables(function.parameters);
  if (function.vararg) out_.symbol(function.parameters.empty() ? "..." : ",...");
  out_.symbol(")");
  // Without this, 5.1 puts the values in a table `arg`, which Luau lacks.
  if (function.vararg) keyword("do local _=... end;");
  Scope* const outer = scope_;
  openScope(function.body, function.parameters);
  functionBlock(function.body);
  scope_ = outer;
  out_.at(function.endLine);
  keyword("end");
}

void ExpressionEmitter::table(const Expr& expr) {
  out_.symbol("{");
  for (size_t i = 0; i < expr.kids.size(); ++i) {
    if (i > 0) out_.symbol(",");
    const Expr* key = expr.keys[i].get();
    if (key && key->kind == ExprKind::string && key->known && isPlainName(key->text)) {
      out_.at(key->line);
      out_.word(key->text);
      out_.symbol("=");
    } else if (key) {
      out_.symbol("[");
      expression(*key);
      out_.symbol("]=");
    }
    expression(*expr.kids[i]);
  }
  out_.symbol("}");
}

}  // namespace obby::luau
