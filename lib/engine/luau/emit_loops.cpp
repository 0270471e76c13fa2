// Emits loops. A body that uses `continue` becomes a loop of its own that runs once. `continue`
// leaves that loop, and `break` first sets a flag for the outer one.
//   while c do local b; repeat BODY until true; if b then break end end
#include <utility>

#include "engine/luau/statement_emitter.h"

namespace obby::luau {

// Emits a body; `names` are the loop's own variables. The scope stays open, since the condition may
// use its variables.
void StatementEmitter::loopBody(const Block& body, const std::vector<std::string>& names,
                                int endLine) {
  openScope(body, names);
  const Leaves leaves = leavesOf(body);
  const bool flagged = std::exchange(flagsBreak_, leaves.continues);
  if (leaves.continues) {
    if (leaves.breaks) {
      keyword("local");
      out_.word(own("b"));
      out_.symbol(";");
    }
    keyword("repeat");
  }
  statements(body);
  out_.at(endLine);
  flagsBreak_ = flagged;
  if (!leaves.continues) return;
  keyword("until true;");
  if (leaves.breaks) {
    keyword("if");
    out_.word(own("b"));
    keyword("then break end;");
  }
}

void StatementEmitter::whileLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("while");
  expression(*stat.values[0]);
  keyword("do");
  loopBody(stat.blocks[0], {}, stat.endLine);
  keyword("end");
  scope_ = outer;
}

void StatementEmitter::repeatLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("repeat");
  loopBody(stat.blocks[0], {}, stat.endLine);
  keyword("until");
  expression(*stat.values[0]);
  scope_ = outer;
}

void StatementEmitter::forLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("for");
  variables(stat.names);
  if (stat.kind == StatKind::numericFor) {
    out_.symbol("=");
    list(stat.values);
  } else {
    keyword("in");
    helper("iter");
    list(stat.values);
    out_.symbol(")");
  }
  keyword("do");
  loopBody(stat.blocks[0], stat.names, stat.endLine);
  keyword("end");
  scope_ = outer;
}

}  // namespace obby::luau
