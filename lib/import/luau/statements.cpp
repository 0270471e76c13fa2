// Statements of the script reader, but for loops.
#include <algorithm>
#include <string>
#include <utility>

#include "import/luau/conditions.h"
#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

// `if humanoid then`: asked of whatever comes along, and so for every player.
bool isOfEveryPlayer(const Datum& condition) {
  const auto* stranger = condition.as<Stranger>();
  return stranger && (stranger->name == "Humanoid" || stranger->name == "Character" ||
                      stranger->name == "HumanoidRootPart");
}

bool isNone(const Datum& value) {
  const auto* flag = value.as<bool>();
  return value.as<Nil>() || (flag && !*flag);
}

// `if not hooked[part] then hooked[part] = true`: it holds as the script first comes there.
bool isFirstTime(const Stat& stat) {
  const Expr& asks = *stat.values[0];
  if (asks.kind != ExprKind::unary || asks.text != "not") return false;
  const Expr& place = *asks.kids[0];
  if (place.kind != ExprKind::index) return false;
  const std::string table = pathOf(*place.kids[0]), key = pathOf(*place.kids[1]);
  if (table.empty() || key.empty()) return false;
  const auto isPlace = [&](const ExprPtr& to) {
    return to->kind == ExprKind::index && pathOf(*to->kids[0]) == table &&
           pathOf(*to->kids[1]) == key;
  };
  const auto sets = [&](const StatPtr& inner) {
    return std::any_of(inner->targets.begin(), inner->targets.end(), isPlace);
  };
  return std::any_of(stat.blocks[0].begin(), stat.blocks[0].end(), sets);
}

}  // namespace

Reader::Flow Reader::walk(const Block& block, bool ownScope) {
  const auto outer = scope_;
  if (ownScope) scope_ = newScope(outer);
  Flow flow = Flow::on;
  for (const auto& stat : block) {
    if (!spend()) flow = Flow::stop;
    if (flow == Flow::on) flow = statement(*stat);
    if (stopped_) flow = Flow::stop;
    if (flow != Flow::on) break;
  }
  scope_ = outer;
  return flow;
}

Reader::Flow Reader::statement(const Stat& stat) {
  ++statements_;
  switch (stat.kind) {
    case StatKind::local: bindLocals(stat); return Flow::on;
    case StatKind::assign:
    case StatKind::compound: return assign(stat);
    case StatKind::call: evaluate(*stat.values[0]); return Flow::on;
    case StatKind::block: return stat.blocks.empty() ? Flow::on : walk(stat.blocks[0]);
    case StatKind::whileLoop:
    case StatKind::repeatLoop: return whileLoop(stat);
    case StatKind::branch: return branch(stat);
    case StatKind::numericFor: return numericFor(stat);
    case StatKind::genericFor: return genericFor(stat);
    case StatKind::function: bindFunction(stat); return Flow::on;
    case StatKind::returns: giveBack(stat); return Flow::leaveFunction;
    case StatKind::leaves: return stat.text == "break" ? Flow::leaveLoop : Flow::nextRound;
  }
  return Flow::on;
}

Reader::Asked Reader::asked(const Expr& condition) {
  const bool denied = condition.kind == ExprKind::unary && condition.text == "not";
  const Datum value = evaluate(denied ? *condition.kids[0] : condition);
  const bool ofAll = isOfEveryPlayer(value);
  const Truth truth = truthOf(value);
  return {denied ? negated(truth) : truth, ofAll && !denied, ofAll && denied};
}

// What follows a way out that may be taken may not be reached. Handlers go on: who asks whether a
// player has touched leaves for all else.
void Reader::doubt(Flow flow, int line) {
  if (flow != Flow::on) ++doubts_;
  noteWayOut(flow, line);
  if (!timeline_.byItself()) return;
  if (flow == Flow::leaveFunction) left_ = true;
  if (flow == Flow::leaveLoop || flow == Flow::nextRound) skipped_ = true;
}

// A branch may have given another value before. An early way out that gives nothing is none.
void Reader::giveBack(const Stat& stat) {
  Datum value = stat.values.empty() ? Datum{Nil{}} : evaluate(*stat.values[0]);
  const bool either = mayReturn_ && (value.as<bool>() || !isNone(maybeReturned_));
  returned_ = either ? oneOf(maybeReturned_, value) : std::move(value);
}

Reader::Flow Reader::branch(const Stat& stat) {
  bool unsure = false;  // an earlier branch may have been taken instead
  const double start = time_;
  double latest = time_;
  for (size_t i = 0; i < stat.blocks.size(); ++i) {
    const Asked condition = i < stat.values.size() ? asked(*stat.values[i]) : Asked{};
    const size_t event = timeline_.events.size();
    if (condition.truth == Truth::no) guard(stat, i, event);
    if (condition.truth == Truth::no) continue;
    if (unsure) time_ = start;
    const bool first = i == 0 && timeline_.trigger == Trigger::start && isFirstTime(stat);
    const bool open = unsure || (condition.truth == Truth::unknown && !condition.always && !first);
    const bool setsUp = timeline_.trigger == Trigger::start && !timeline_.forever;
    const bool either = open && (setsUp || again_);
    if (open) ++unsure_;
    if (either) variables_.beginBranch();
    const Flow flow = walk(stat.blocks[i]);
    if (either)
      spend(variables_.endBranch(flow != Flow::on, i == 0 ? defaulted(*stat.values[0]) : ""));
    guard(stat, i, event);
    if (open) --unsure_;
    latest = std::max(latest, time_);
    if (flow == Flow::stop) return flow;
    const bool sure = condition.truth == Truth::yes && !unsure;
    if (flow == Flow::leaveFunction && !sure && !condition.never) {
      mayReturn_ = true;
      maybeReturned_ = returned_;
    }
    if (open && !condition.never) doubt(flow, stat.line);
    if (condition.truth == Truth::yes) {
      time_ = latest;
      return unsure ? Flow::on : flow;
    }
    unsure = true;
  }
  time_ = latest;
  return Flow::on;
}

void Reader::bindLocals(const Stat& stat) {
  const auto values = evaluateAll(stat.values, 0);
  for (size_t i = 0; i < stat.names.size(); ++i) {
    Datum value = i < values.size() ? values[i] : Datum{};
    if (stat.values.empty()) value = {Nil{}};
    scope_->names[stat.names[i]] = std::move(value);
  }
}

void Reader::bindFunction(const Stat& stat) {
  const Expr& function = *stat.values[0];
  if (!stat.names.empty()) scope_->names[stat.names[0]] = {};
  const Datum closure{Closure{function.body.get(), scope_}};
  if (!stat.names.empty()) {
    scope_->names[stat.names[0]] = closure;
    return;
  }
  const Expr& target = *stat.targets[0];
  if (target.kind == ExprKind::name) {
    Scope* holder = scope_->holder(target.text);
    (holder ? holder : scope_)->names[target.text] = closure;
  } else {
    setField(evaluate(*target.kids[0]), target.text, closure, stat.line);
  }
}

Reader::Flow Reader::assign(const Stat& stat) {
  auto values = evaluateAll(stat.values, 0);
  for (size_t i = 0; i < stat.targets.size(); ++i) {
    const Expr& target = *stat.targets[i];
    Datum value = i < values.size() ? values[i] : Datum{};
    if (stat.kind == StatKind::compound) value = arithmetic(stat.text, evaluate(target), value);
    if (target.kind == ExprKind::name) {
      Scope* const found = scope_->holder(target.text);
      Scope* const holder = found ? found : scope_;
      variables_.set(holder->names, target.text, std::move(value), isOwn(holder->born));
    } else if (target.kind == ExprKind::field) {
      setField(evaluate(*target.kids[0]), target.text, value, stat.line);
    } else if (target.kind == ExprKind::index) {
      const Datum key = evaluate(*target.kids[1]);
      setIndexed(evaluate(*target.kids[0]), key, value, stat.line);
    }
  }
  return Flow::on;
}

// Of numbers the places in a list and the one behind its last.
void Reader::setIndexed(const Datum& object, const Datum& key, const Datum& value, int line) {
  if (const auto* name = key.as<std::string>()) return setField(object, *name, value, line);
  const auto* table = object.as<Table*>();
  const auto* place = key.as<double>();
  if (!table) return;
  auto& items = (*table)->items;
  // `list[n] = part` where the text does not tell how often `n` was counted up.
  if (key.as<Unknown>() && value.as<Ref>()) items.push_back(value);
  if (!place || !(*place >= 1)) return;
  if (*place <= double(items.size()))
    items[size_t(*place) - 1] = value;
  else if (*place == double(items.size()) + 1)
    items.push_back(value);
}

}  // namespace obby::importer::luau
