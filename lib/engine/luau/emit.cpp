// The entry point of the emitter, and its scopes.
#include "engine/luau/emit.h"

#include <fmt/format.h>

#include "engine/luau/parser.h"
#include "engine/luau/statement_emitter.h"

namespace obby::luau {

std::string StatementEmitter::chunk(const Chunk& chunk) {
  out_.word("local");
  out_.word(prefix_);
  out_.symbol("=...;");
  body(chunk.body);
  return out_.take();
}

void StatementEmitter::body(const Block& block) {
  Scope* const outer = scope_;
  openScope(block, {});
  statements(block);
  scope_ = outer;
}

void ExpressionEmitter::openScope(const Block& block, const std::vector<std::string>& names) {
  scope_ = &scopes_.of(block);
  if (scope_->table == 0) return;
  keyword("local");
  out_.word(own(fmt::format("t{}", scope_->table)));
  out_.symbol("={");
  for (const auto& name : names) {
    const std::string field = declared(name);
    out_.word(field.substr(field.find('.') + 1));
    out_.symbol("=");
    out_.word(variable(name));
    out_.symbol(",");
  }
  out_.symbol("};");
}

void ExpressionEmitter::variables(const std::vector<std::string>& names) {
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out_.symbol(",");
    out_.word(variable(names[i]));
  }
}

std::string ExpressionEmitter::declared(std::string_view name) {
  if (scope_->table == 0) return variable(name);
  return fmt::format("{}t{}.{}_{}", prefix_, scope_->table, name, declared_[scope_]++);
}

bool ExpressionEmitter::isOwnLocal(const Expr& expr) const {
  if (expr.kind != ExprKind::name) return false;
  const Local* local = scopes_.find(expr);
  return local && local->scope->table == 0 && local->scope->function == scope_->function;
}

Result<std::string> emit(const Chunk& chunk) {
  if (chunk.broken) {
    Error error = makeError(chunk.error);
    error.place = std::to_string(chunk.errorLine);
    return error;
  }
  auto scopes = resolve(chunk);
  if (!scopes) return std::move(scopes).error();
  return StatementEmitter(*scopes).chunk(chunk);
}

Result<std::string> toLua(std::string_view source) { return emit(parse(source)); }

}  // namespace obby::luau
