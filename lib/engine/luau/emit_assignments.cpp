// Emits assignments. Luau assigns from left to right, Lua 5.1 from right to left. If the order is
// observable, objects, keys and values go to temporary variables first.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/luau/statement_emitter.h"

namespace obby::luau {
namespace {

bool orderShows(const Stat& stat) {
  if (stat.targets.size() < 2) return false;
  std::set<std::string_view> names;
  for (const auto& target : stat.targets)
    if (target->kind != ExprKind::name || !names.insert(target->text).second) return true;
  return false;
}

// Returns true if the expression contains a call or a function that begins below the line, or a
// function that ends below it. Their lines must not change.
bool actsBelow(const Expr& expr, int line) {
  const bool acts = expr.kind == ExprKind::call || expr.kind == ExprKind::method || expr.body;
  if (acts && expr.line > line) return true;
  if (expr.body) return expr.body->endLine > line;
  const auto below = [&](const ExprPtr& kid) { return kid && actsBelow(*kid, line); };
  return std::any_of(expr.kids.begin(), expr.kids.end(), below) ||
         std::any_of(expr.keys.begin(), expr.keys.end(), below);
}

bool isConstant(const Expr& expr) {
  return expr.kind == ExprKind::number || (expr.kind == ExprKind::string && expr.known);
}

}  // namespace

// Emits an assignment. Lua 5.1 reports the line where its value ends, Luau the line where it
// begins. Observed changes must name Luau's line, so a value moves up if only its arguments are on
// further lines.
void StatementEmitter::assignment(const Stat& stat) {
  const auto acts = [&](const ExprPtr& expr) { return actsBelow(*expr, stat.line); };
  const bool plain = std::none_of(stat.values.begin(), stat.values.end(), acts) &&
                     std::none_of(stat.targets.begin(), stat.targets.end(), acts);
  const bool stayed = out_.stay(plain);
  if (stat.kind == StatKind::compound)
    compound(stat);
  else
    assign(stat);
  out_.stay(stayed);
}

void StatementEmitter::assign(const Stat& stat) {
  if (orderShows(stat)) return assignInOrder(stat);
  list(stat.targets);
  out_.symbol("=");
  list(stat.values);
}

// do local o1,k1,o2=OBJECT,KEY,OBJECT local v1,v2=VALUES o1[k1]=v1 o2.field=v2 end
void StatementEmitter::assignInOrder(const Stat& stat) {
  keyword("do");
  bindTargets(stat);
  keyword("local");
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    if (i > 0) out_.symbol(",");
    out_.word(own(fmt::format("v{}", i)));
  }
  out_.symbol("=");
  list(stat.values);
  out_.symbol(";");
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    const Expr& target = *stat.targets[i];
    if (target.kind == ExprKind::name)
      bare(target);
    else
      out_.word(own(fmt::format("o{}", i)));
    if (target.kind == ExprKind::field) {
      out_.symbol(".");
      out_.word(target.text);
    } else if (target.kind == ExprKind::index) {
      out_.symbol("[");
      out_.word(own(fmt::format("k{}", i)));
      out_.symbol("]");
    }
    out_.symbol("=");
    out_.word(own(fmt::format("v{}", i)));
    out_.symbol(";");
  }
  keyword("end");
}

void StatementEmitter::bindTargets(const Stat& stat) {
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    if (stat.targets[i]->kind != ExprKind::name) bindTarget(*stat.targets[i], std::to_string(i));
  }
}

// local o,k=OBJECT,KEY;
void StatementEmitter::bindTarget(const Expr& target, const std::string& number) {
  const bool index = target.kind == ExprKind::index;
  keyword("local");
  out_.word(own("o" + number));
  if (index) {
    out_.symbol(",");
    out_.word(own("k" + number));
  }
  out_.symbol("=");
  single(*target.kids[0]);
  if (index) {
    out_.symbol(",");
    single(*target.kids[1]);
  }
  out_.symbol(";");
}

template <class Write>
void StatementEmitter::update(const Stat& stat, const Write& write) {
  const Expr& value = *stat.values[0];
  write();
  out_.symbol("=");
  if (stat.text == "//" || stat.text == "..") {
    helper(stat.text == "//" ? "idiv" : "cat");
    write();
    out_.symbol(",");
    single(value);
    out_.symbol(")");
  } else {
    write();
    out_.symbol(stat.text);
    if (value.kind == ExprKind::binary)
      bracketed(value);
    else
      expression(value);
  }
}

void StatementEmitter::compound(const Stat& stat) {
  const Expr& target = *stat.targets[0];
  if (target.kind == ExprKind::name) return update(stat, [&] { bare(target); });
  const bool keyIsPlain = target.kind == ExprKind::field || isConstant(*target.kids[1]);
  // Luau does not copy local variables either: a closure in the value may change them.
  if (isOwnLocal(*target.kids[0]) && keyIsPlain) return update(stat, [&] { bare(target); });
  compoundField(stat);
}

// do local o,k=OBJECT,KEY o[k]=o[k]+VALUE end
void StatementEmitter::compoundField(const Stat& stat) {
  const Expr& target = *stat.targets[0];
  const bool index = target.kind == ExprKind::index;
  keyword("do");
  bindTarget(target, "");
  update(stat, [&] {
    out_.word(own("o"));
    out_.symbol(index ? "[" + own("k") + "]" : "." + target.text);
  });
  keyword("end");
}

}  // namespace obby::luau
