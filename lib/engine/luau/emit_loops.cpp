// Loops. A body that uses `continue` becomes a loop of its own, which runs once: `continue` leaves
// that one, and `break` sets a flag for the outer one before.
//   while c do local b; repeat BODY until true; if b then break end end
#include <utility>

#include "engine/luau/emitter_state.h"

namespace obby::luau {

// `variables` are the loop's own. The scope stays open: a condition may see it.
void Emitter::loopBody(const Block& body, const std::vector<std::string>& variables, int endLine) {
  openScope(body, variables);
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

void Emitter::whileLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("while");
  expression(*stat.values[0]);
  keyword("do");
  loopBody(stat.blocks[0], {}, stat.endLine);
  keyword("end");
  scope_ = outer;
}

void Emitter::repeatLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("repeat");
  loopBody(stat.blocks[0], {}, stat.endLine);
  keyword("until");
  expression(*stat.values[0]);
  scope_ = outer;
}

void Emitter::forLoop(const Stat& stat) {
  Scope* const outer = scope_;
  keyword("for");
  for (size_t i = 0; i < stat.names.size(); ++i) {
    if (i > 0) out_.symbol(",");
    out_.word(stat.names[i]);
  }
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
