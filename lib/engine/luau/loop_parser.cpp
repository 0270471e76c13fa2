// Parses loops.
#include "engine/luau/statement_parser.h"

namespace obby::luau {

Block StatementParser::loopBody() {
  ++around_.loops;
  Block body = block();
  --around_.loops;
  return body;
}

StatPtr StatementParser::whileLoop(int line) {
  auto stat = makeStat(StatKind::whileLoop, line);
  stat->values.push_back(expression());
  expectKeyword("do");
  stat->blocks.push_back(loopBody());
  stat->endLine = peek().line;
  closeKeyword("end", "while", line);
  return stat;
}

StatPtr StatementParser::repeatLoop(int line) {
  auto stat = makeStat(StatKind::repeatLoop, line);
  stat->blocks.push_back(loopBody());
  stat->endLine = peek().line;
  closeKeyword("until", "repeat", line);
  stat->values.push_back(expression());
  return stat;
}

StatPtr StatementParser::forLoop(int line) {
  auto stat = makeStat(StatKind::genericFor, line);
  do {
    stat->names.push_back(nameToken());
    annotation();
  } while (accept(","));
  if (stat->names.size() == 1 && accept("=")) {
    stat->kind = StatKind::numericFor;
    stat->values = expressionList();
    if (stat->values.size() < 2) failHere("',' and the last value of the loop");
    if (stat->values.size() > 3)
      fail(line, "'for' takes only a first value, a last value and a step");
  } else {
    expectKeyword("in");
    stat->values = expressionList();
  }
  expectKeyword("do");
  stat->blocks.push_back(loopBody());
  stat->endLine = peek().line;
  closeKeyword("end", "for", line);
  return stat;
}

}  // namespace obby::luau
