// Emits statements except assignments and loops. Simple ones end with `;`, so that a `(` after them
// begins a statement.
#include <utility>

#include "engine/luau/statement_emitter.h"

namespace obby::luau {

void StatementEmitter::functionBlock(const Block& body) {
  const bool flagged = std::exchange(flagsBreak_, false);
  statements(body);
  flagsBreak_ = flagged;
}

void StatementEmitter::statements(const Block& body) {
  for (const auto& stat : body) statement(*stat);
}

void StatementEmitter::statement(const Stat& stat) {
  if (stat.kind == StatKind::block && stat.blocks.empty()) return;  // a type declaration
  out_.at(stat.line);
  switch (stat.kind) {
    case StatKind::local: local(stat); break;
    case StatKind::assign:
    case StatKind::compound: assignment(stat); break;
    case StatKind::call: expression(*stat.values[0]); break;
    case StatKind::block:
      keyword("do");
      body(stat.blocks[0]);
      end(stat);
      break;
    case StatKind::whileLoop: whileLoop(stat); break;
    case StatKind::repeatLoop: repeatLoop(stat); break;
    case StatKind::branch: branch(stat); break;
    case StatKind::numericFor:
    case StatKind::genericFor: forLoop(stat); break;
    case StatKind::function: function(stat); break;
    case StatKind::returns: returns(stat); break;
    case StatKind::leaves: leaves(stat); break;
  }
  out_.symbol(";");
}

void StatementEmitter::local(const Stat& stat) {
  const bool table = scope_->table != 0;
  if (!table) keyword("local");
  if (table && stat.values.empty()) {  // the table is new, so the fields are nil
    for (const auto& name : stat.names) declared(name);
    return keyword("do end");
  }
  // The values cannot refer to these variables: the resolver has bound the same names to earlier
  // ones.
  for (size_t i = 0; i < stat.names.size(); ++i) {
    if (i > 0) out_.symbol(",");
    out_.word(declared(stat.names[i]));
  }
  if (stat.values.empty()) return;
  out_.symbol("=");
  list(stat.values);
}

void StatementEmitter::branch(const Stat& stat) {
  for (size_t i = 0; i < stat.blocks.size(); ++i) {
    if (i < stat.values.size()) {
      keyword(i == 0 ? "if" : "elseif");
      expression(*stat.values[i]);
      keyword("then");
    } else {
      keyword("else");
    }
    body(stat.blocks[i]);
  }
  end(stat);
}

void StatementEmitter::function(const Stat& stat) {
  const bool isLocal = stat.targets.empty();
  if (isLocal && scope_->table == 0) keyword("local");
  keyword("function");
  if (isLocal)
    out_.word(declared(stat.names[0]));
  else
    bare(*stat.targets[0]);
  functionBody(*stat.values[0]->body);
}

// Emits a return. `return f()` would be a tail call, which Luau does not have: tracebacks and error
// positions would lack the function.
void StatementEmitter::returns(const Stat& stat) {
  keyword("return");
  if (stat.values.size() != 1) return list(stat.values);
  const Expr& value = *stat.values[0];
  const bool call = isMulti(value) && value.kind != ExprKind::vararg;
  if (call) {
    helper("all");
    expression(value);
    out_.symbol(")");
  } else if (value.kind == ExprKind::vararg) {
    expression(value);
  } else {
    single(value);
  }
}

void StatementEmitter::leaves(const Stat& stat) {
  if (flagsBreak_ && stat.text == "break") {
    out_.word(own("b"));
    out_.symbol("=true;");
  }
  keyword("break");
}

}  // namespace obby::luau
