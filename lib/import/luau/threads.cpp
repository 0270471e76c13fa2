// Calls of the functions of a script, at once, beside what follows, and on a trigger.
#include <algorithm>
#include <utility>

#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kMaxCalls = 12;      // one in the other
constexpr size_t kStepsOfAValue = 4;  // that is kept for a handler

}  // namespace

// A function that waits and calls itself, however deep, is an endless loop: its first round counts.
bool Reader::endlessCall(const Closure& closure) {
  const auto isIt = [&](const Active& active) { return active.function == closure.function; };
  const auto first = std::find_if(active_.begin(), active_.end(), isIt);
  if (first == active_.end() || timeline_.forever || finishing_ || !timeline_.byItself())
    return false;
  const auto second = std::find_if(first + 1, active_.end(), isIt);
  if (second == active_.end() || !(second->time > first->time)) return false;
  timeline_.forever = true;
  timeline_.loopStart = first->time;
  timeline_.loopEvent = first->event;
  timeline_.period = second->time - first->time;
  timeline_.events.resize(second->event);
  time_ = second->time;
  stopped_ = true;
  return true;
}

Datum Reader::call(const Closure& closure, const std::vector<Datum>& arguments) {
  if (!closure.function || !spend()) return {};
  if (active_.size() >= kMaxCalls) {
    if (!arguments.empty() || !endlessCall(closure)) reading_.exhausted = true;
    return {};
  }
  active_.push_back({closure.function, time_, timeline_.events.size()});
  const bool left = left_, skipped = skipped_;
  const size_t guards = guards_.size();
  const auto outer = scope_;
  scope_ = newScope(closure.scope);
  const auto& parameters = closure.function->parameters;
  for (size_t i = 0; i < parameters.size(); ++i)
    scope_->names[parameters[i]] = i < arguments.size() ? arguments[i] : Datum{};
  returned_ = {Nil{}};
  const Datum maybe = maybeReturned_;
  const bool mayReturn = std::exchange(mayReturn_, false);
  if (walk(closure.function->body, false) == Flow::stop) stopped_ = true;
  scope_ = outer;
  maybeReturned_ = maybe;
  mayReturn_ = mayReturn;
  left_ = left;
  skipped_ = skipped;
  active_.pop_back();
  if (!active_.empty()) closeGuards(guards);
  return std::exchange(returned_, Datum{});
}

void Reader::later(Pending pending, const Datum& function, std::vector<Datum> arguments) {
  const auto* closure = function.as<Closure>();
  if (!closure || pending_.size() >= kMaxTimelines) return;
  pending.closure = *closure;
  pending.arguments = std::move(arguments);
  spend(variables_.note(*closure));
  // What each frame does begins as it is connected; other handlers count from their trigger.
  const bool atStart = timeline_.trigger == Trigger::start;
  if (pending.trigger == Trigger::frame && atStart) {
    pending.time = time_;
    pending.left = left_;
    pending.vague = vague_;
    pending.awaited = hasAwaited();
  }
  // An early way out of the script would keep it from all handlers, and not from this one.
  if (atStart) pending.unsure = unsure_ > 0 || skipped_;
  pending.found = variables_.heldNow(pending.trigger == Trigger::frame);
  spend(pending.found.size() * kStepsOfAValue);
  pending.triggered = triggered_ && pending.trigger == Trigger::frame;
  pending.ofHandler = timeline_.trigger != Trigger::start;
  pending_.push_back(std::move(pending));
}

void Reader::beside(const Datum& function, const std::vector<Datum>& arguments, double delay) {
  const auto* closure = function.as<Closure>();
  if (!closure) return;
  if (timeline_.trigger == Trigger::start) {
    if (pending_.size() >= kMaxTimelines) return;
    Pending pending;
    pending.closure = *closure;
    pending.arguments = arguments;
    spend(variables_.note(*closure));
    pending.time = time_ + delay;
    pending.unsure = unsure_ > 0 || skipped_;
    pending.left = left_;
    pending.vague = vague_;
    pending.awaited = hasAwaited();
    pending_.push_back(std::move(pending));
    return;
  }
  const double now = time_;
  const bool ended = ended_;
  time_ += delay;
  call(*closure, arguments);
  if (time_ > now) ended_ = ended;  // the handler comes until then
  time_ = now;
  stopped_ = false;
}

}  // namespace obby::importer::luau
