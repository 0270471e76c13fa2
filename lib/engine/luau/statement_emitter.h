// Emits statements. Assignments and loops have a file each.
#pragma once

#include <string>
#include <vector>

#include "engine/luau/expression_emitter.h"

namespace obby::luau {

class StatementEmitter final : private ExpressionEmitter {
 public:
  explicit StatementEmitter(Scopes& scopes) : ExpressionEmitter(scopes) {}

  std::string chunk(const Chunk& chunk);

 private:
  void functionBlock(const Block& body) override;
  void statements(const Block& body);
  void statement(const Stat& stat);
  void local(const Stat& stat);
  void branch(const Stat& stat);
  void function(const Stat& stat);
  void returns(const Stat& stat);
  void leaves(const Stat& stat);
  // Emits the `end` of a block statement, on its line.
  void end(const Stat& stat) {
    out_.at(stat.endLine);
    keyword("end");
  }
  void body(const Block& block);  // emits a block with its scope

  // Assignments.
  void assignment(const Stat& stat);
  void assign(const Stat& stat);
  void assignInOrder(const Stat& stat);
  void bindTargets(const Stat& stat);
  void bindTarget(const Expr& target, const std::string& number);
  void compound(const Stat& stat);
  void compoundField(const Stat& stat);
  // Emits `target = target op value`; `write` writes the target.
  template <class Write>
  void update(const Stat& stat, const Write& write);

  // Loops.
  void whileLoop(const Stat& stat);
  void repeatLoop(const Stat& stat);
  void forLoop(const Stat& stat);
  void loopBody(const Block& body, const std::vector<std::string>& names, int endLine);

  bool flagsBreak_ = false;  // the loop's body is a loop of its own, so leaving it sets a flag
};

}  // namespace obby::luau
