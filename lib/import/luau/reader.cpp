// Timelines of the script reader.
#include "import/luau/reader.h"

#include <string>
#include <utility>

namespace obby::importer::luau {
namespace {

// What a player does in the game, and not by coming into it.
bool isTrigger(Trigger trigger, const std::string& signal) {
  return trigger == Trigger::touch || signal == "MouseClick" || signal == "Triggered";
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
  while (!pending_.empty() && reading_.timelines.size() < kMaxTimelines && spend() &&
         room_.take()) {
    const Pending next = std::move(pending_.front());
    pending_.pop_front();
    follow(next);
  }
  reading_.exhausted = reading_.exhausted || room_.isFull() || !pending_.empty();
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

}  // namespace obby::importer::luau
