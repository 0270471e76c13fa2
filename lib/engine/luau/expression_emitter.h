// Emits expressions (operators and literals have a file each), and keeps the scopes that resolve
// variables.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/luau/ast.h"
#include "engine/luau/scopes.h"
#include "engine/luau/writer.h"

namespace obby::luau {

class ExpressionEmitter {
 public:
  virtual ~ExpressionEmitter() = default;

 protected:
  using Exprs = std::vector<ExprPtr>;
  static constexpr size_t kMaxArguments = 100;  // per helper call: registers are scarce

  explicit ExpressionEmitter(Scopes& scopes) : scopes_(scopes), prefix_(scopes.freePrefix()) {}

  // Emits the statements of a function expression.
  virtual void functionBlock(const Block& body) = 0;

  // Scopes.
  void openScope(const Block& block, const std::vector<std::string>& names);
  // Returns the emitted name of a local variable. 5.1 has a hidden variable `arg` in functions with
  // `...`.
  std::string variable(std::string_view name) const {
    return name == "arg" ? own(name) : std::string(name);
  }
  void variables(const std::vector<std::string>& names);
  // Returns the name of a variable that is declared here, or the field that holds it.
  std::string declared(std::string_view name);
  bool isOwnLocal(const Expr& expr) const;  // local variable of this very function

  // Expressions.
  void expression(const Expr& expr);
  void bare(const Expr& expr);       // emits it without its own parentheses
  void single(const Expr& expr);     // emits it adjusted to one value in any position
  void bracketed(const Expr& expr);  // emits (expr), with one pair of parentheses
  void list(const Exprs& exprs, size_t from = 0);
  void name(const Expr& expr);
  void call(const Expr& expr);
  void functionBody(const Function& function);
  void table(const Expr& expr);

  // Operators.
  void unary(const Expr& expr);
  void binary(const Expr& expr);
  void quotient(const Expr& left, const Expr& right);
  void concatenation(const std::vector<const Expr*>& operands);
  void choice(const Expr& expr);
  void condition(const Expr& expr);

  // Literals.
  void number(double value);
  void string(std::string_view value);
  void interpolation(const Expr& expr);
  void interpolation(const std::vector<const Expr*>& parts, size_t from);

  void keyword(std::string_view word) { out_.word(word); }
  void helper(std::string_view name) {  // Emits L_.name(
    out_.word(prefix_);
    out_.symbol(".");
    out_.word(name);
    out_.symbol("(");
  }
  std::string own(std::string_view name) const { return prefix_ + std::string(name); }

  Scopes& scopes_;
  const std::string& prefix_;
  Writer out_;
  Scope* scope_ = nullptr;

 private:
  std::unordered_map<const Scope*, int> declared_;  // variables so far, in scopes with tables
};

// Returns true for a call or `...` that is not in parentheses: it may be any number of values.
inline bool isMulti(const Expr& expr) {
  return !expr.parenthesised && (expr.kind == ExprKind::call || expr.kind == ExprKind::method ||
                                 expr.kind == ExprKind::vararg);
}

// Returns the operands of a chain of `..`, from left to right.
std::vector<const Expr*> concatenated(const Expr& expr);

}  // namespace obby::luau
