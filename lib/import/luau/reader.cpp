// Timelines and statements of the script reader.
#include "import/luau/reader.h"

#include <algorithm>

namespace obby::importer::luau {
namespace {

constexpr int kMaxCalls = 12;
constexpr size_t kMaxTimelines = 50000;

// `if humanoid then`: asked of whatever comes along, and so for every player.
bool isOfEveryPlayer(const Datum& condition) {
  const auto* stranger = condition.as<Stranger>();
  return stranger && (stranger->name == "Humanoid" || stranger->name == "Character" ||
                      stranger->name == "HumanoidRootPart");
}

}  // namespace

Reader::Reader(const Tree& tree, InstanceId script, size_t& budget) : tree_(tree), budget_(budget) {
  scope_ = newScope(nullptr);
  reading_.script = script;
}

Scope* Reader::newScope(Scope* parent) {
  Scope* scope = arena_.make<Scope>();
  scope->parent = parent;
  return scope;
}

ScriptReading Reader::read(const Chunk& chunk) {
  scope_->names["script"] = {Ref{reading_.script}};
  timeline_ = {};
  walk(chunk.body, false);
  finishTweens();
  timeline_.end = time_;
  reading_.timelines.push_back(std::move(timeline_));
  while (!pending_.empty() && reading_.timelines.size() < kMaxTimelines && spend()) {
    const Pending next = std::move(pending_.front());
    pending_.pop_front();
    follow(next);
  }
  reading_.broken = chunk.broken;
  return std::move(reading_);
}

void Reader::follow(const Pending& pending) {
  inHandler_ = pending.trigger != Trigger::start;  // what it writes ends with it
  beforeHandler_.clear();
  timeline_ = {};
  timeline_.trigger = pending.trigger;
  timeline_.touched = pending.touched;
  timeline_.signal = pending.signal;
  timeline_.line = pending.line;
  time_ = pending.time;
  stopped_ = false;
  zone_ = kNoInstance;
  unsure_ = 0;
  if (pending.trigger == Trigger::frame) {
    const Function* body = pending.closure.function;
    const auto outer = scope_;
    scope_ = newScope(pending.closure.scope);
    for (size_t i = 0; i < body->parameters.size() && i < pending.arguments.size(); ++i)
      scope_->names[body->parameters[i]] = pending.arguments[i];
    foreverLoop(body->body, nullptr, true);
    scope_ = outer;
  } else {
    call(pending.closure, pending.arguments);
  }
  finishTweens();
  timeline_.end = time_;
  reading_.timelines.push_back(std::move(timeline_));
  for (auto& [key, old] : beforeHandler_) {
    if (old)
      written_[key] = *old;
    else
      written_.erase(key);
  }
}

// What the end of each tween sets off. A tween that plays again closes a loop.
void Reader::finishTweens() {
  constexpr size_t kMaxChain = 64;
  finishing_ = true;
  for (size_t i = 0; i < played_.size() && i < kMaxChain && !timeline_.forever; ++i) {
    const Played played = played_[i];
    if (played.tween->timing.repeats < 0) continue;
    time_ = played.time + played.tween->timing.total();
    const auto completed = played.tween->completed;  // what is called may connect more
    for (const Closure& closure : completed) call(closure, {});
  }
  played_.clear();
  finishing_ = false;
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
    case StatKind::returns:
      returned_ = stat.values.empty() ? Datum{Nil{}} : evaluate(*stat.values[0]);
      return Flow::leaveFunction;
    case StatKind::leaves: return stat.text == "break" ? Flow::leaveLoop : Flow::nextRound;
  }
  return Flow::on;
}

Reader::Flow Reader::branch(const Stat& stat) {
  bool unsure = false;  // an earlier branch may have been taken instead
  const double start = time_;
  double latest = time_;
  for (size_t i = 0; i < stat.blocks.size(); ++i) {
    const Datum condition = i < stat.values.size() ? evaluate(*stat.values[i]) : Datum{true};
    const Truth truth = truthOf(condition);
    if (truth == Truth::no) continue;
    if (unsure) time_ = start;
    const bool open = unsure || (truth == Truth::unknown && !isOfEveryPlayer(condition));
    if (open) ++unsure_;
    const Flow flow = walk(stat.blocks[i]);
    if (open) --unsure_;
    latest = std::max(latest, time_);
    if (flow == Flow::stop) return flow;
    if (truth == Truth::yes) {
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
      Scope* holder = scope_->holder(target.text);
      (holder ? holder : scope_)->names[target.text] = std::move(value);
    } else if (target.kind == ExprKind::field) {
      setField(evaluate(*target.kids[0]), target.text, value, stat.line);
    } else if (target.kind == ExprKind::index) {
      const Datum key = evaluate(*target.kids[1]);
      if (const auto* name = key.as<std::string>())
        setField(evaluate(*target.kids[0]), *name, value, stat.line);
    }
  }
  return Flow::on;
}

Datum Reader::call(const Closure& closure, const std::vector<Datum>& arguments) {
  if (!closure.function || depth_ >= kMaxCalls || !spend()) return {};
  ++depth_;
  const auto outer = scope_;
  scope_ = newScope(closure.scope);
  const auto& parameters = closure.function->parameters;
  for (size_t i = 0; i < parameters.size(); ++i)
    scope_->names[parameters[i]] = i < arguments.size() ? arguments[i] : Datum{};
  returned_ = {Nil{}};
  if (walk(closure.function->body, false) == Flow::stop) stopped_ = true;
  scope_ = outer;
  --depth_;
  return std::exchange(returned_, Datum{});
}

void Reader::later(Pending pending, const Datum& function, std::vector<Datum> arguments) {
  const auto* closure = function.as<Closure>();
  if (!closure || pending_.size() >= kMaxTimelines) return;
  pending.closure = *closure;
  pending.arguments = std::move(arguments);
  // What each frame does begins as it is connected; other handlers count from their trigger.
  if (pending.trigger == Trigger::frame && timeline_.trigger == Trigger::start)
    pending.time = time_;
  pending_.push_back(std::move(pending));
}

void Reader::beside(const Datum& function, const std::vector<Datum>& arguments, double delay) {
  const auto* closure = function.as<Closure>();
  if (!closure) return;
  if (timeline_.trigger == Trigger::start) {
    if (pending_.size() < kMaxTimelines)
      pending_.push_back({Trigger::start, kNoInstance, {}, 0, *closure, arguments, time_ + delay});
    return;
  }
  const double now = time_;
  time_ += delay;
  call(*closure, arguments);
  time_ = now;
  stopped_ = false;
}

}  // namespace obby::importer::luau
