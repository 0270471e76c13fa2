// Timelines and statements of the script reader.
#include "import/luau/reader.h"

#include <algorithm>

#include "import/luau/conditions.h"

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

// What a player does in the game, and not by coming into it.
bool isTrigger(Trigger trigger, const std::string& signal) {
  return trigger == Trigger::touch || signal == "MouseClick" || signal == "Triggered";
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

Reader::Reader(const Tree& tree, InstanceId script, size_t& budget, size_t room,
               const Changes* changes)
    : tree_(tree), changes_(changes), budget_(budget), room_(room) {
  scope_ = newScope(nullptr);
  reading_.script = script;
}

Scope* Reader::newScope(Scope* parent) {
  Scope* scope = arena_.make<Scope>();
  scope->parent = parent;
  scope->born = followed_;
  variables_.make(scope->names);
  return scope;
}

ScriptReading Reader::read(const Chunk& chunk) {
  scope_->names["script"] = {Ref{reading_.script}};
  assignments_ = Assignments(chunk.body);
  mayHarm_ = mentionsHarm();
  timeline_ = {};
  walk(chunk.body, false);
  finishTweens();
  leaveGoing();
  leaveLoop();
  timeline_.end = time_;
  timeline_.vague = vague_;
  keepTimeline();
  while (!pending_.empty() && reading_.timelines.size() < kMaxTimelines && spend() && takeRoom()) {
    const Pending next = std::move(pending_.front());
    pending_.pop_front();
    follow(next);
  }
  reading_.exhausted = reading_.exhausted || !pending_.empty();
  nameEnded();
  readAgain();
  reading_.broken = chunk.broken;
  return std::move(reading_);
}

void Reader::openTimeline(const Pending& pending) {
  inHandler_ = pending.trigger != Trigger::start;  // what it writes ends with it
  beforeHandler_.clear();
  beforeLoop_.clear();
  timeline_ = {};
  ++followed_;
  timeline_.trigger = pending.trigger;
  triggered_ = pending.triggered || isTrigger(timeline_.trigger, pending.signal);
  timeline_.touched = pending.touched;
  timeline_.signal = pending.signal;
  timeline_.line = pending.line;
  if (pending.awaited) timeline_.awaits = 0;
  handler_ = pending.connection;
  body_ = pending.closure.function;
  ended_ = pending.once;
  time_ = pending.time;
  stopped_ = false;
  zone_ = kNoInstance;
  unsure_ = pending.unsure ? 1 : 0;
  timeline_.maybe = pending.unsure;
  left_ = pending.left;
  skipped_ = false;
  vague_ = pending.vague;
}

// All timelines of a place are kept at once, and nothing is added to this one.
void Reader::keepTimeline() {
  timeline_.events.shrink_to_fit();
  reading_.timelines.push_back(std::move(timeline_));
}

void Reader::follow(const Pending& pending) {
  openTimeline(pending);
  if (inHandler_)
    variables_.beginHandler(body_, pending.trigger == Trigger::frame, pending.found);
  else
    variables_.beginThread(body_);
  const bool ownClock = triggered_ || !timeline_.byItself();
  std::map<Key, std::vector<Going>> others;  // by the clock of the game
  if (ownClock) others.swap(going_);
  if (pending.trigger == Trigger::frame)
    followEachFrame(pending);
  else
    call(pending.closure, pending.arguments);
  finishTweens();
  nameOnce(pending);
  leaveGoing();
  leaveLoop();
  timeline_.end = time_;
  timeline_.vague = vague_;
  if (ownClock) going_.swap(others);
  const bool over = pending.trigger == Trigger::frame && ended_;
  if (over) timeline_.trigger = Trigger::start;  // it comes but once, by the clock of the game
  if (pending.triggered || (over && pending.ofHandler)) timeline_.trigger = Trigger::other;
  keepHarmless(pending);
  if (handler_ != 0 && !over) handlers_[reading_.timelines.size()] = handler_;
  keepTimeline();
  variables_.endHandler();
  for (auto& [key, old] : beforeHandler_) {
    if (old)
      written_[key] = *old;
    else
      written_.erase(key);
  }
}

void Reader::followEachFrame(const Pending& pending) {
  const Function* body = pending.closure.function;
  const auto outer = scope_;
  scope_ = newScope(pending.closure.scope);
  const auto begins = [&](int) {
    for (size_t i = 0; i < body->parameters.size() && i < pending.arguments.size(); ++i)
      scope_->names[body->parameters[i]] = pending.arguments[i];
    if (pending.signal == "Stepped" && !body->parameters.empty())  // the first one is the clock
      scope_->names[body->parameters[0]] = {time_};
    return true;
  };
  foreverLoop(body->body, begins, true);
  scope_ = outer;
}

bool Reader::spend(size_t steps) {
  if (budget_ > steps) {
    budget_ -= steps;
    return true;
  }
  budget_ = 0;
  reading_.exhausted = true;
  return false;
}

bool Reader::takeRoom() {
  if (room_ > 0) {
    --room_;
    return true;
  }
  full_ = reading_.exhausted = true;
  return false;
}

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
