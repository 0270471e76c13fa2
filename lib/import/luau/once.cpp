// What a handler of a touch does but once: it sets a flag that keeps it from the next time.
#include <algorithm>
#include <string>
#include <utility>

#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kMaxGuards = 64;     // of a handler
constexpr int kHighest = 12;          // condition that is looked through
constexpr size_t kAskedPerStep = 8;   // expressions of conditions
constexpr size_t kMarkedPerStep = 8;  // events

bool isAndOr(const Expr& expr) {
  return expr.kind == ExprKind::binary && (expr.text == "and" || expr.text == "or");
}

bool isEqual(const Expr& expr) {
  return expr.kind == ExprKind::binary && (expr.text == "==" || expr.text == "~=");
}

bool isNot(const Expr& expr) { return expr.kind == ExprKind::unary && expr.text == "not"; }

bool isLogical(const Expr& expr) { return isAndOr(expr) || isEqual(expr) || isNot(expr); }

Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes ? b : a;
}

}  // namespace

bool Reader::asksFlag(const Expr& expr, size_t& looked) const {
  ++looked;
  if (const std::string name = flagName(expr); !name.empty()) return assignments_.isFlag(name);
  return isLogical(expr) && std::any_of(expr.kids.begin(), expr.kids.end(),
                                        [&](const ExprPtr& kid) { return asksFlag(*kid, looked); });
}

// After a branch, whose events begin with `event`: they may come but once, and so may all that
// follows a branch that leaves the function.
void Reader::guard(const Stat& stat, size_t branch, size_t event) {
  if (timeline_.trigger != Trigger::touch || branch >= stat.values.size()) return;
  const Expr& condition = *stat.values[branch];
  if (condition.height > kHighest || guards_.size() >= kMaxGuards) return;
  size_t looked = 0;
  const bool asks = asksFlag(condition, looked);
  spend(looked / kAskedPerStep);
  if (!asks) return;
  const size_t now = timeline_.events.size();
  if (now > event) guards_.push_back({&condition, scope_, stat.line, true, event, now});
  const Block& block = stat.blocks[branch];
  if (!block.empty() && block.back()->kind == StatKind::returns)
    guards_.push_back({&condition, scope_, stat.line, false, now, kOpenEnd});
}

// What a function leaves does not keep its caller from anything.
void Reader::closeGuards(size_t from) {
  for (size_t i = from; i < guards_.size(); ++i)
    guards_[i].end = std::min(guards_[i].end, timeline_.events.size());
}

// Whether what an expression leads to, by names alone, is there when the handler comes again.
bool Reader::outlives(const Expr& expr, Scope* scope, Scope* outside) const {
  if (expr.kind == ExprKind::name) {
    Scope* holder = scope->holder(expr.text);
    if (!holder || outside->holder(expr.text) == holder) return true;
    return holder->names[expr.text].as<Ref>() != nullptr;
  }
  const bool asks =
      expr.kind == ExprKind::method && expr.kids.size() == 2 &&
      expr.kids[1]->kind == ExprKind::string &&
      (expr.text == "GetAttribute" || expr.text == "WaitForChild" || expr.text == "FindFirstChild");
  const bool leads = expr.kind == ExprKind::field ||
                     (expr.kind == ExprKind::index && expr.kids[1]->kind == ExprKind::string);
  return (asks || leads) && outlives(*expr.kids[0], scope, outside);
}

// The value of a flag that outlives the handler and that nothing sets back. Unknown: it is none.
Datum Reader::flagOf(const Expr& expr, Scope* scope, Scope* outside) {
  const std::string name = flagName(expr);
  if (!assignments_.isFlag(name) || !outlives(expr, scope, outside)) return {};
  Scope* const now = std::exchange(scope_, scope);
  Datum value = evaluate(expr);
  scope_ = now;
  return assignments_.isSet(name, value) ? value : Datum{};
}

// What a condition gives when the handler comes again, as far as flags tell.
Truth Reader::nextTime(const Expr& expr, Scope* scope, Scope* outside) {
  if (!spend()) return Truth::unknown;
  const auto of = [&](size_t kid) { return nextTime(*expr.kids[kid], scope, outside); };
  if (isNot(expr)) return negated(of(0));
  if (isAndOr(expr) && expr.text == "and") return both(of(0), of(1));
  if (isAndOr(expr)) return negated(both(negated(of(0)), negated(of(1))));
  const bool equal = isEqual(expr);
  const bool turned = equal && !literalOf(*expr.kids[0]).as<Unknown>();  // `false == done`
  const Datum flag = flagOf(equal ? *expr.kids[turned ? 1 : 0] : expr, scope, outside);
  if (!equal) return truthOf(flag);
  return truthOf(compared(expr.text, flag, literalOf(*expr.kids[turned ? 0 : 1])));
}

// Flags of a handler that another one makes count only if they outlive that one, too.
void Reader::nameOnce(const Pending& pending) {
  Scope* outside = pending.closure.scope;
  while (pending.ofHandler && outside->parent) outside = outside->parent;
  for (const Guard& guard : guards_) {
    const Truth again = nextTime(*guard.condition, guard.scope, outside);
    if (again != (guard.holds ? Truth::no : Truth::yes)) continue;
    const size_t end = std::min(guard.end, timeline_.events.size());
    if (!spend((end - guard.first) / kMarkedPerStep)) break;
    for (size_t i = guard.first; i < end; ++i) timeline_.events[i].onceLine = guard.line;
  }
  guards_.clear();
}

}  // namespace obby::importer::luau
