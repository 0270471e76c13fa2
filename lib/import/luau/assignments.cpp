// One walk over the parsed script, functions and all.
#include "import/luau/assignments.h"

namespace obby::importer::luau {
namespace {

constexpr unsigned kNil = 1, kTruth = 2, kFalsehood = 4, kOther = 8;

unsigned kindOf(const Expr& value) {
  if (value.kind == ExprKind::nil) return kNil;
  if (value.kind == ExprKind::truth) return kTruth;
  return value.kind == ExprKind::falsehood ? kFalsehood : kOther;
}

}  // namespace

bool Assignments::isFlag(const std::string& name) const {
  const auto given = given_.find(name);
  if (given == given_.end()) return false;
  return given->second == kNil || given->second == kTruth || given->second == kFalsehood;
}

bool Assignments::isSet(const std::string& name, const Datum& value) const {
  const auto given = given_.find(name);
  if (given == given_.end()) return false;
  if (value.as<Nil>()) return given->second == kNil;
  const auto* flag = value.as<bool>();
  return flag && given->second == (*flag ? kTruth : kFalsehood);
}

void Assignments::walk(const Block& block, bool outermost) {
  for (const StatPtr& stat : block) {
    if (!outermost) take(*stat);
    for (const ExprPtr& target : stat->targets) walk(*target);
    for (const ExprPtr& value : stat->values) walk(*value);
    for (const Block& inner : stat->blocks) walk(inner, outermost && stat->kind == StatKind::block);
  }
}

void Assignments::walk(const Expr& expr) {
  for (const ExprPtr& kid : expr.kids) walk(*kid);
  for (const ExprPtr& key : expr.keys)
    if (key) walk(*key);
  if (expr.body) walk(expr.body->body, false);
}

void Assignments::take(const Stat& stat) {
  const bool plain = stat.kind == StatKind::assign;
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    const Expr& target = *stat.targets[i];
    if (target.kind != ExprKind::name) continue;
    given_[target.text] |= plain && i < stat.values.size() ? kindOf(*stat.values[i]) : kOther;
  }
}

}  // namespace obby::importer::luau
