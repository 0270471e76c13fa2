// The emitter's state and its parts: statements, assignments, loops, expressions, operators and
// literals have a file each.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/luau/ast.h"
#include "engine/luau/scopes.h"
#include "engine/luau/writer.h"

namespace obby::luau {

class Emitter {
 public:
  explicit Emitter(Scopes& scopes) : scopes_(scopes), prefix_(scopes.freePrefix()) {}

  std::string chunk(const Chunk& chunk);

 private:
  using Exprs = std::vector<ExprPtr>;
  static constexpr size_t kMostArguments = 100;  // of a helper: registers are scarce

  // Statements.
  void statements(const Block& body);
  void statement(const Stat& stat);
  void local(const Stat& stat);
  void branch(const Stat& stat);
  void function(const Stat& stat);
  void returns(const Stat& stat);
  void leaves(const Stat& stat);
  void keyword(std::string_view word) { out_.word(word); }
  // `end` of a block statement, on its line.
  void end(const Stat& stat) {
    out_.at(stat.endLine);
    keyword("end");
  }

  // Assignments.
  void assign(const Stat& stat);
  void assignInOrder(const Stat& stat);
  void bindTargets(const Stat& stat);
  void compound(const Stat& stat);
  void compoundField(const Stat& stat);
  // `target = target op value`, where the target is written by `write`.
  template <class Write>
  void update(const Stat& stat, const Write& write);

  // Loops.
  void whileLoop(const Stat& stat);
  void repeatLoop(const Stat& stat);
  void forLoop(const Stat& stat);
  void loopBody(const Block& body, const std::vector<std::string>& variables, int endLine);

  // Scopes.
  void body(const Block& block);  // with its scope
  void openScope(const Block& block, const std::vector<std::string>& variables);
  // The name of a variable that is declared here, or the field that holds it.
  std::string declared(std::string_view name);
  bool isOwnLocal(const Expr& expr) const;  // a local variable of this very function

  // Expressions.
  void expression(const Expr& expr);
  void bare(const Expr& expr);       // without its own parentheses
  void single(const Expr& expr);     // adjusted to one value wherever it stands
  void bracketed(const Expr& expr);  // (expr), once
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

  void helper(std::string_view name) {  // L_.name(
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
  std::unordered_map<const Scope*, int> declared_;  // variables so far, of a scope with a table
  bool flagsBreak_ = false;  // the loop's body is a loop of its own: leaving it sets a flag
};

// A call or `...` that is not in parentheses: it may be any number of values.
inline bool isMulti(const Expr& expr) {
  return !expr.parenthesised && (expr.kind == ExprKind::call || expr.kind == ExprKind::method ||
                                 expr.kind == ExprKind::vararg);
}

// The operands of a chain of `..`, from left to right.
std::vector<const Expr*> concatenated(const Expr& expr);

}  // namespace obby::luau
