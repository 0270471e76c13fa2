// The emitter's entry, and its scopes.
#include "engine/luau/emit.h"

#include <fmt/format.h>

#include "engine/luau/emitter_state.h"
#include "engine/luau/parser.h"

namespace obby::luau {

std::string Emitter::chunk(const Chunk& chunk) {
  out_.word("local");
  out_.word(prefix_);
  out_.symbol("=...;");
  body(chunk.body);
  return out_.take();
}

void Emitter::body(const Block& block) {
  Scope* const outer = scope_;
  openScope(block, {});
  statements(block);
  scope_ = outer;
}

void Emitter::openScope(const Block& block, const std::vector<std::string>& variables) {
  scope_ = &scopes_.of(block);
  if (scope_->table == 0) return;
  keyword("local");
  out_.word(own(fmt::format("t{}", scope_->table)));
  out_.symbol("={");
  for (const auto& variable : variables) {
    const std::string field = declared(variable);
    out_.word(field.substr(field.find('.') + 1));
    out_.symbol("=");
    out_.word(variable);
    out_.symbol(",");
  }
  out_.symbol("};");
}

std::string Emitter::declared(std::string_view name) {
  if (scope_->table == 0) return std::string(name);
  return fmt::format("{}t{}.{}_{}", prefix_, scope_->table, name, declared_[scope_]++);
}

bool Emitter::isOwnLocal(const Expr& expr) const {
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
  return Emitter(*scopes).chunk(chunk);
}

Result<std::string> toLua(std::string_view source) { return emit(parse(source)); }

}  // namespace obby::luau
