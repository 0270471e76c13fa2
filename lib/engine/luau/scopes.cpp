// One walk over the script with the variables in scope.
#include "engine/luau/scopes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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
  static constexpr int kForLoopLocals = 3;  // that Lua keeps of its own

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
  void functionStatement(const Stat& stat);
  void assignTo(const Expr& target);
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
  Scope* watched_ = nullptr;  // the body of a loop whose condition is looked at
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
  scope_ = nullptr;  // whoever opened it sets its own again
}

void Resolver::declare(std::string_view name, bool constant) {
  seen(name);
  Local& local = out_.locals_.emplace_back();
  local = {name, scope_, int(scope_->locals.size()), constant};
  scope_->locals.push_back(&local);
  visible_[name].push_back(&local);
  function_->most = std::max(function_->most, ++function_->active);
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
      block(stat.blocks[0]);
      break;
    case StatKind::branch: branch(stat); break;
    case StatKind::repeatLoop: repeatLoop(stat); break;
    case StatKind::numericFor:
    case StatKind::genericFor: forLoop(stat); break;
    case StatKind::function: functionStatement(stat); break;
    case StatKind::call:
    case StatKind::returns: expressions(stat.values); break;
    case StatKind::leaves: break;
  }
  scope_ = scope;
}

void Resolver::branch(const Stat& stat) {
  for (size_t i = 0; i < stat.blocks.size(); ++i) {
    if (i < stat.values.size()) expression(*stat.values[i]);
    block(stat.blocks[i]);
  }
}

// With `continue` the body becomes a loop of its own, and the condition stands outside of it: the
// variables that the condition sees then live in a table.
void Resolver::repeatLoop(const Stat& stat) {
  Scope& scope = open(stat.blocks[0]);
  statements(stat.blocks[0]);
  Scope* const watched = watched_;
  if (leavesOf(stat.blocks[0]).continues) watched_ = &scope;
  expression(*stat.values[0]);
  watched_ = watched;
  close(scope);
}

void Resolver::forLoop(const Stat& stat) {
  expressions(stat.values);
  function_->active += kForLoopLocals;
  Scope& scope = open(stat.blocks[0]);
  for (const auto& name : stat.names) declare(name);
  statements(stat.blocks[0]);
  close(scope);
  function_->active -= kForLoopLocals;
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
  if (!local || !local->constant || failed_) return;
  failed_ = true;
  error_ = makeError(fmt::format("'{:.40}' is a constant: it cannot be assigned to", local->name));
  error_.place = std::to_string(target.line);
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
  if (local->scope == watched_) watched_->table = 1;
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
