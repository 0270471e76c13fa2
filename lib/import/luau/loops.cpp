// While and repeat loops of the script reader. Those that bring about their own end are followed
// round by round; endless ones until the parts they move are back where the loop began.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "import/frame_time.h"
#include "import/luau/conditions.h"
#include "import/luau/reader.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

constexpr int kMaxRounds = 1500;       // of an endless loop
constexpr double kMaxSeconds = 25;     // of an endless loop
constexpr double kMaxIdle = 5;         // seconds in which a handler of each frame does nothing
constexpr size_t kIdleSteps = 300000;  // of that in a script: leaves steps for the rest
constexpr float kSamePlace = 2e-3f;    // studs
constexpr float kSameTurn = 2e-3f;     // radians
constexpr size_t kMaxEvents = 200000;  // of one timeline

// Properties that make a loop worth following for more than one round.
bool isTracked(const ScriptEvent& event) {
  return event.kind == EventKind::set &&
         (event.property == "CFrame" || event.property == "CanCollide") &&
         (event.frame || event.flag);
}

bool sameDatum(const Datum& a, const Datum& b) {
  if (const auto* fa = a.as<Frame>()) {
    const auto* fb = b.as<Frame>();
    return fb && length(fa->pose.position - fb->pose.position) < kSamePlace &&
           length(rotationVector(fa->pose.rotation * inverse(fb->pose.rotation))) < kSameTurn;
  }
  const auto *flagA = a.as<bool>(), *flagB = b.as<bool>();
  return flagA && flagB ? *flagA == *flagB : true;
}

bool sameState(const std::map<std::pair<InstanceId, std::string>, Datum>& a,
               const std::map<std::pair<InstanceId, std::string>, Datum>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && sameDatum(x.second, y.second);
  });
}

// Finds the rounds of a loop that leave all as the first two did.
class Repetition {
 public:
  using State = std::map<std::pair<InstanceId, std::string>, Datum>;

  // After a round that has set something, with what is then and the time. True once it has come
  // round again.
  bool take(const State& now, double time) {
    if (done_ == 0) firstTime_ = time;
    if (done_ < 2) (done_ == 0 ? first_ : second_) = now;
    if (matched_ && sameState(now, second_)) return true;
    matched_ = done_ > 0 && sameState(now, first_);
    matchTime_ = time;
    ++done_;
    return false;
  }
  double period() const { return matchTime_ - firstTime_; }

 private:
  State first_, second_;
  double firstTime_ = 0, matchTime_ = 0;
  bool matched_ = false;
  int done_ = 0;  // rounds
};

}  // namespace

Reader::Flow Reader::walkRound(const Block& body) {
  const bool skipped = skipped_;
  ++loops_;
  const Flow flow = walk(body);
  --loops_;
  skipped_ = skipped;
  return flow == Flow::nextRound ? Flow::on : flow;
}

// A loop that brings about its own end, as `while part.Transparency < 1 do` with a step in it, or
// waits for the clock or for the end of a tween. One that no condition ends is followed until it
// takes a way out, or may.
Reader::Flow Reader::countingLoop(const Stat& stat, bool repeats) {
  const double start = time_;
  const size_t before = timeline_.events.size(), doubts = doubts_;
  const bool endless = isFixed(*stat.values[0]);
  for (const std::string& path : pathsOf(*stat.values[0]))
    if (Scope* holder = scope_->holder(path); holder && !isOwn(holder->born))
      variables_.settle(holder->names, path);
  for (int round = 0; round < kMaxCount; ++round) {
    const Truth goesOn = repeats ? Truth::yes : truthOf(evaluate(*stat.values[0]));
    if (goesOn == Truth::no) return Flow::on;
    const bool open = goesOn == Truth::unknown;
    if (open) ++unsure_;
    const Flow flow = walkRound(stat.blocks[0]);
    if (open) --unsure_;
    if (open) await();
    if (flow == Flow::leaveLoop) return Flow::on;
    if (flow != Flow::on || open) return flow;
    if (endless && doubts_ > doubts) {
      await();
      vague_ = vague_ || time_ > start;
      return Flow::on;
    }
    if (!repeats) continue;
    const Truth over = truthOf(evaluate(*stat.values[0]));
    if (over == Truth::unknown) await();
    if (over != Truth::no) return Flow::on;
  }
  // What the rounds that are not followed would do is lost, and how long they take.
  if (timeline_.events.size() > before) reading_.exhausted = true;
  if (time_ > start) vague_ = true;
  return Flow::on;
}

// What follows comes only once something has happened that the text does not tell.
void Reader::await() { timeline_.awaits = std::min(timeline_.awaits, timeline_.events.size()); }

Reader::Flow Reader::whileLoop(const Stat& stat) {
  const Expr& condition = *stat.values[0];
  const bool repeats = stat.kind == StatKind::repeatLoop;
  const std::set<std::string> paths = pathsOf(condition);
  const std::set<std::string> poses = posesAmong(paths);
  const bool turns = asksTween(condition) || (!poses.empty() && assigns(stat.blocks[0], poses));
  if (asksClock(paths) || (!paths.empty() && assigns(stat.blocks[0], paths)) ||
      (turns && isTold(condition)))
    return countingLoop(stat, repeats);
  const bool waits = !repeats && isWait(condition);
  const double start = time_;
  Truth truth = truthOf(evaluate(condition));
  time_ = start;
  if (repeats) truth = negated(truth);
  if (truth == Truth::no && !waits && !repeats) return Flow::on;
  const bool endless = truth == Truth::yes || waits ||
                       (timeline_.trigger == Trigger::start && active_.empty() && !repeats);
  const bool sure = truth == Truth::yes && isFixed(condition);
  if (sure && countsToWayOut(stat.blocks[0])) return countingLoop(stat, repeats);
  const size_t event = timeline_.events.size();
  const bool asksPose = !poses.empty() && truth == Truth::yes;
  const auto begins = [&](int round) {
    const auto& events = timeline_.events;  // what may not be set ends nothing
    const bool told = asksPose && round > 0 && !(events.size() > event && events.back().unsure);
    if (!waits && !told) return true;
    const Truth holds = truthOf(evaluate(condition));
    return waits || holds != (repeats ? Truth::yes : Truth::no);
  };
  const Flow flow = endless ? foreverLoop(stat.blocks[0], begins, sure) : walkRound(stat.blocks[0]);
  const bool passed = time_ > start && timeline_.events.size() == event;
  if (passed) endGoing();
  if (flow == Flow::stop && timeline_.forever && assigns(stat.blocks[0], paths, true))
    reading_.waysOut.push_back(stat.line);
  if (flow != Flow::stop && (passed || truth == Truth::unknown)) await();
  return flow == Flow::leaveLoop ? Flow::on : flow;
}

// What this loop has written so far of the properties that a loop can bring back.
Reader::State Reader::trackedState() const {
  State state;
  for (const auto& [key, old] : beforeLoop_)
    if (key.second == "CFrame" || key.second == "CanCollide") state[key] = written_.at(key);
  return state;
}

void Reader::beginLoop() {
  timeline_.forever = true;
  timeline_.loopStart = time_;
  timeline_.loopEvent = timeline_.events.size();
  beforeLoop_.clear();
  variables_.beginLoop();
  endless_ = {loops_ + 1, active_.size(), 0};
}

// Attributes that an endless loop sets, maybe to and fro, are not known when another timeline asks.
void Reader::leaveLoop() {
  if (!timeline_.forever) return;
  variables_.endLoop(true);
  for (const auto& [key, old] : beforeLoop_)
    if (key.second.rfind("@", 0) == 0) written_[key] = {};
}

// Rounds are followed until two in a row leave the parts as the first two did: one alone may pass
// the same place on the way back. A loop that is not sure to be endless, or has a way out, and does
// nothing but wait ends with what it waits for: what follows it is read. A handler of each frame
// may return before it does anything: its rounds are those that do. One that disconnects itself
// ends with that round.
// Of an endless loop in another one the first round stands for all, unless it ends by no condition
// and a later round is sure to leave it.
Reader::Flow Reader::foreverLoop(const Block& body, const RoundStart& begins, bool sure) {
  const bool nested = timeline_.forever;
  const bool handler = timeline_.trigger == Trigger::frame && !nested;
  const bool ways = sure && !handler && canLeave(body, false);
  const bool passable = !sure || (ways && !nested);
  if (!nested) beginLoop();
  Repetition repetition;
  double lastSet = time_;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double roundStart = time_;
    const size_t event = timeline_.events.size(), budget = budget_, doubts = doubts_;
    const Flow flow = begins && !begins(round) ? Flow::leaveLoop : walkRound(body);
    const bool returns = handler && flow == Flow::leaveFunction;
    if (timeline_.trigger == Trigger::frame) time_ = std::max(time_, roundStart + kFrame);
    const bool idle =
        passable && round == 0 && flow == Flow::on && timeline_.events.size() == event;
    if (idle && sure && !timeline_.byItself()) vague_ = vague_ || time_ > roundStart;
    const bool leaves = flow == Flow::leaveFunction && !returns;
    const bool ends = flow == Flow::leaveLoop || leaves || idle || (handler && ended_);
    if (ends && !nested) variables_.endLoop(false);
    if (ends) timeline_.forever = nested;
    if (ends) return leaves ? flow : Flow::on;
    timeline_.period = time_ - timeline_.loopStart;
    if (flow != Flow::on && !returns) return flow;
    const auto begin = timeline_.events.begin() + std::ptrdiff_t(event);
    const bool sets = std::any_of(begin, timeline_.events.end(), isTracked);
    if (sets) lastSet = time_;
    if (returns && !sets) idleSteps_ += budget - budget_;
    const bool goesOn = sets || (returns && time_ - lastSet < kMaxIdle && idleSteps_ < kIdleSteps);
    if ((nested && (!ways || doubts_ > doubts)) || time_ <= roundStart ||
        timeline_.period > kMaxSeconds || timeline_.events.size() > kMaxEvents || !goesOn)
      break;
    if (!sets || nested) continue;
    if (!repetition.take(trackedState(), time_)) continue;
    timeline_.closed = true;
    timeline_.period = repetition.period();
    break;
  }
  // A handler comes again, whichever way it has left its loop.
  if (!nested && timeline_.trigger == Trigger::start) keepWayOut(body);
  return nested ? Flow::on : Flow::stop;
}

}  // namespace obby::importer::luau
