// Resolves names in one walk over the script with the variables in scope.
#include "engine/luau/scopes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace obby::luau {

class Resolver {
 public:
  Result<Scopes> run(const Chunk& chunk) {
    out_.byName_.reserve(1024);
    enterFunction(nullptr, chunk.body);
    if (failed_) return error_;
    spill(out_.functions_, out_.scopes_);
    for (int i = 0; out_.prefix_.empty() || takenPrefixes_.contains(out_.prefix_); ++i)
      out_.prefix_ = i == 0 ? "L_" : fmt::format("L{}_", i);
    return std::move(out_);
  }

 private:
  static constexpr int kForLoopLocals = 3;  // hidden locals of a Lua loop

  // The first `continue` of a loop.
  struct Continue {
    Scope* body = nullptr;
    int line = 0;      // 0: none so far
    int declared = 0;  // number of variables of the body before it
  };

  void enterFunction(const Function* function, const Block& body);
  Scope& open(const Block& block);
  void close(Scope& scope);
  void declare(std::string_view name, bool constant = false);
  void block(const Block& body) {
    Scope& scope = open(body);
    statements(body);
    close(scope);
  }
  void statements(const Block& body) {
    for (const auto& stat : body) statement(*stat);
  }
  void statement(const Stat& stat);
  void branch(const Stat& stat);
  void repeatLoop(const Stat& stat);
  void forLoop(const Stat& stat);
  std::pair<Scope*, Continue> loopBody(const Stat& stat);
  void functionStatement(const Stat& stat);
  void assignTo(const Expr& target);
  void fail(int line, std::string message);
  void expressions(const std::vector<ExprPtr>& list) {
    for (const auto& expr : list)
      if (expr) expression(*expr);
  }
  void expression(const Expr& expr);
  void name(const Expr& expr);
  void seen(std::string_view name);

  Scopes out_;
  std::unordered_map<std::string_view, std::vector<Local*>> visible_;
  std::set<std::string, std::less<>> takenPrefixes_;
  FunctionScope* function_ = nullptr;
  Scope* scope_ = nullptr;
  Continue continue_;  // the first `continue` of the innermost loop
  Continue skips_;     // the first `continue` of the loop whose condition is being resolved
  bool failed_ = false;
  Error error_;
};

void Resolver::enterFunction(const Function* function, const Block& body) {
  FunctionScope& inner = out_.functions_.emplace_back();
  inner.outer = function_;
  function_ = &inner;
  Scope& scope = open(body);
  if (function)
    for (const auto& parameter : function->parameters) declare(parameter);
  statements(body);
  close(scope);
  function_ = inner.outer;
}

Scope& Resolver::open(const Block& block) {
  Scope& scope = out_.scopes_.emplace_back();
  scope.function = function_;
  function_->scopes.push_back(&scope);
  out_.byBlock_[&block] = &scope;
  scope_ = &scope;
  return scope;
}

void Resolver::close(Scope& scope) {
  for (const Local* local : scope.locals) visible_[local->name].pop_back();
  function_->active -= int(scope.locals.size());
  scope_ = nullptr;  // the caller restores its own scope
}

void Resolver::declare(std::string_view name, bool constant) {
  seen(name);
  Local& local = out_.locals_.emplace_back();
  local = {name, scope_, int(scope_->locals.size()), constant};
  scope_->locals.push_back(&local);
  visible_[name].push_back(&local);
  function_->maxActive = std::max(function_->maxActive, ++function_->active);
}

void Resolver::seen(std::string_view name) {
  if (name.empty() || name[0] != 'L') return;
  size_t end = 1;
  while (end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
  if (end < name.size() && name[end] == '_') takenPrefixes_.emplace(name.substr(0, end + 1));
}

void Resolver::statement(const Stat& stat) {
  Scope* const scope = scope_;
  switch (stat.kind) {
    case StatKind::local:
      expressions(stat.values);
      for (const auto& name : stat.names) declare(name, stat.text == "const");
      break;
    case StatKind::assign:
    case StatKind::compound:
      for (const auto& target : stat.targets) assignTo(*target);
      expressions(stat.values);
      break;
    case StatKind::block:
      for (const auto& body : stat.blocks) block(body);
      break;
    case StatKind::whileLoop:
      expressions(stat.values);
      close(*loopBody(stat).first);
      break;
    case StatKind::branch: branch(stat); break;
    case StatKind::repeatLoop: repeatLoop(stat); break;
    case StatKind::numericFor:
    case StatKind::genericFor: forLoop(stat); break;
    case StatKind::function: functionStatement(stat); break;
    case StatKind::call:
    case StatKind::returns: expressions(stat.values); break;
    case StatKind::leaves:
      if (stat.text == "continue" && continue_.line == 0)
        continue_ = {continue_.body, stat.line, int(continue_.body->locals.size())};
      break;
  }
  scope_ = scope;
}

void Resolver::branch(const Stat& stat) {
  for (size_t i = 0; i < stat.blocks.size(); ++i) {
    if (i < stat.values.size()) expression(*stat.values[i]);
    block(stat.blocks[i]);
  }
}

// With `continue` the body becomes a loop of its own, and the condition is outside of it. Variables
// that the condition uses then live in a table.
void Resolver::repeatLoop(const Stat& stat) {
  const auto [body, first] = loopBody(stat);
  const Continue outer = skips_;
  if (first.line != 0) skips_ = first;
  expression(*stat.values[0]);
  skips_ = outer;
  close(*body);
}

void Resolver::forLoop(const Stat& stat) {
  expressions(stat.values);
  function_->active += kForLoopLocals;
  close(*loopBody(stat).first);
  function_->active -= kForLoopLocals;
}

// Resolves a body and leaves its scope open.
std::pair<Scope*, Resolver::Continue> Resolver::loopBody(const Stat& stat) {
  const Continue outer = continue_;
  Scope& scope = open(stat.blocks[0]);
  continue_ = {&scope, 0, 0};
  for (const auto& name : stat.names) declare(name);
  statements(stat.blocks[0]);
  return {&scope, std::exchange(continue_, outer)};
}

void Resolver::functionStatement(const Stat& stat) {
  if (stat.targets.empty())
    declare(stat.names[0]);
  else
    assignTo(*stat.targets[0]);
  expressions(stat.values);
}

void Resolver::assignTo(const Expr& target) {
  expression(target);
  const Local* local = target.kind == ExprKind::name ? out_.find(target) : nullptr;
  if (local && local->constant)
    fail(target.line, fmt::format("'{:.40}' is a constant: it cannot be assigned to", local->name));
}

void Resolver::fail(int line, std::string message) {
  if (failed_) return;
  failed_ = true;
  error_ = makeError(std::move(message));
  error_.place = std::to_string(line);
}

void Resolver::expression(const Expr& expr) {
  if (expr.kind == ExprKind::name) return name(expr);
  if (expr.body) {
    Scope* const scope = scope_;
    enterFunction(expr.body.get(), expr.body->body);
    scope_ = scope;
    return;
  }
  if (!expr.keys.empty() && expr.kind == ExprKind::table) {
    for (size_t i = 0; i < expr.kids.size(); ++i) {
      if (expr.keys[i]) expression(*expr.keys[i]);
      expression(*expr.kids[i]);
    }
    return;
  }
  expressions(expr.kids);
}

void Resolver::name(const Expr& expr) {
  const auto found = visible_.find(expr.text);
  if (found == visible_.end() || found->second.empty()) return seen(expr.text);
  const Local* local = found->second.back();
  out_.byName_.emplace(&expr, local);
  if (local->scope == skips_.body) {
    skips_.body->table = 1;
    if (local->index >= skips_.declared)
      fail(expr.line, fmt::format("the 'continue' of line {} skips '{:.40}', which the loop's "
                                  "condition needs",
                                  skips_.line, local->name));
  }
  for (FunctionScope* f = function_; f != local->scope->function; f = f->outer)
    f->upvalues.insert(local);
}

const Local* Scopes::find(const Expr& name) const {
  const auto found = byName_.find(&name);
  return found == byName_.end() ? nullptr : found->second;
}

Result<Scopes> resolve(const Chunk& chunk) { return Resolver().run(chunk); }

Leaves leavesOf(const Block& body) {
  Leaves leaves;
  for (const auto& stat : body) {
    if (stat->kind == StatKind::leaves)
      (stat->text == "break" ? leaves.breaks : leaves.continues) = true;
    if (stat->kind != StatKind::block && stat->kind != StatKind::branch) continue;
    for (const auto& inner : stat->blocks) {
      const Leaves more = leavesOf(inner);
      leaves.breaks |= more.breaks;
      leaves.continues |= more.continues;
    }
  }
  return leaves;
}

}  // namespace obby::luau
