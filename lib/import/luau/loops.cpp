// Loops of the script reader. Counted loops are followed round by round; endless ones until the
// parts they move are back where the loop began.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "import/luau/conditions.h"
#include "import/luau/reader.h"
#include "import/pose_math.h"

namespace obby::importer::luau {
namespace {

constexpr double kFrame = 1.0 / 60;
constexpr int kMaxRounds = 1500;       // of an endless loop
constexpr double kMaxSeconds = 25;     // of an endless loop
constexpr double kMaxIdle = 5;         // seconds in which a handler of each frame does nothing
constexpr size_t kIdleSteps = 300000;  // of that in a script: leaves steps for the rest
constexpr int kMaxCount = 2000;        // of a counted loop
constexpr float kSamePlace = 2e-3f;    // studs
constexpr float kSameTurn = 2e-3f;     // radians
constexpr size_t kMaxEvents = 200000;  // of one timeline
constexpr size_t kAskedPerStep = 2;    // expressions of a condition
constexpr double kLatest = 1e9;        // seconds: later than anything that counts

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
  const Flow flow = walk(body);
  skipped_ = skipped;
  return flow == Flow::nextRound ? Flow::on : flow;
}

// Whether each round sets one of these. What a branch sets, it may as well not.
bool Reader::assigns(const Block& body, const std::set<std::string>& paths) {
  return std::any_of(body.begin(), body.end(), [&](const StatPtr& stat) {
    if (!spend()) return false;
    const bool sets = std::any_of(stat->targets.begin(), stat->targets.end(), [&](const auto& to) {
      return stat->kind != StatKind::function && paths.count(pathOf(*to)) > 0;
    });
    if (sets || stat->kind == StatKind::branch) return sets;
    return std::any_of(stat->blocks.begin(), stat->blocks.end(),
                       [&](const Block& block) { return assigns(block, paths); });
  });
}

// Whether a round of a loop can leave it, by a break of its own or by a return.
bool Reader::canLeave(const Block& body, bool inner) {
  return std::any_of(body.begin(), body.end(), [&](const StatPtr& stat) {
    if (!spend()) return false;
    if (stat->kind == StatKind::returns) return true;
    if (stat->kind == StatKind::leaves) return !inner && stat->text == "break";
    const bool loop = stat->kind == StatKind::whileLoop || stat->kind == StatKind::repeatLoop ||
                      stat->kind == StatKind::numericFor || stat->kind == StatKind::genericFor;
    return std::any_of(stat->blocks.begin(), stat->blocks.end(),
                       [&](const Block& block) { return canLeave(block, inner || loop); });
  });
}

// A loop that brings about its own end, as `while part.Transparency < 1 do` with a step in it, or
// waits for the clock or for the end of a tween.
Reader::Flow Reader::countingLoop(const Stat& stat, bool repeats) {
  const double start = time_;
  const size_t before = timeline_.events.size();
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

// Whether the text tells if the condition holds as the loop begins; no time goes by.
bool Reader::isTold(const Expr& condition) {
  const double start = time_;
  const bool known = truthOf(evaluate(condition)) != Truth::unknown;
  time_ = start;
  return known;
}

// What follows comes only once something has happened that the text does not tell.
void Reader::await() { timeline_.awaits = std::min(timeline_.awaits, timeline_.events.size()); }

Reader::Flow Reader::whileLoop(const Stat& stat) {
  const Expr& condition = *stat.values[0];
  const bool repeats = stat.kind == StatKind::repeatLoop;
  size_t looked = 0;
  const std::set<std::string> paths = pathsIn(condition, looked);
  spend(looked / kAskedPerStep);
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
  const size_t event = timeline_.events.size();
  const Flow flow = endless ? foreverLoop(stat.blocks[0], waits ? &condition : nullptr, sure)
                            : walkRound(stat.blocks[0]);
  const bool passed = time_ > start && timeline_.events.size() == event;
  if (passed) endGoing();
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
}

// Rounds are followed until two in a row leave the parts as the first two did: one alone may pass
// the same place on the way back. A loop that is not sure to be endless and does nothing but wait
// ends with what it waits for: what follows it is read. A handler of each frame may return before
// it does anything: its rounds are those that do. One that disconnects itself ends with that round.
// Of an endless loop in another one the first round stands for all, unless it ends by no condition
// and a later round is sure to leave it.
Reader::Flow Reader::foreverLoop(const Block& body, const Expr* condition, bool sure) {
  const bool nested = timeline_.forever;
  const bool handler = timeline_.trigger == Trigger::frame && !nested;
  const bool leaving = nested && sure && canLeave(body, false);
  if (!nested) beginLoop();
  Repetition repetition;
  double lastSet = time_;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double roundStart = time_;
    const size_t event = timeline_.events.size(), budget = budget_, doubts = doubts_;
    if (condition) evaluate(*condition);
    const Flow flow = walkRound(body);
    const bool returns = handler && flow == Flow::leaveFunction;
    if (timeline_.trigger == Trigger::frame) time_ = std::max(time_, roundStart + kFrame);
    const bool idle = round == 0 && flow == Flow::on && timeline_.events.size() == event;
    const bool leaves = flow == Flow::leaveFunction && !returns;
    const bool ends = flow == Flow::leaveLoop || leaves || (idle && !sure) || (handler && ended_);
    if (ends) timeline_.forever = nested;
    if (ends) return leaves ? flow : Flow::on;
    timeline_.period = time_ - timeline_.loopStart;
    if (flow != Flow::on && !returns) return flow;
    const auto begin = timeline_.events.begin() + std::ptrdiff_t(event);
    const bool sets = std::any_of(begin, timeline_.events.end(), isTracked);
    if (sets) lastSet = time_;
    if (returns && !sets) idleSteps_ += budget - budget_;
    const bool goesOn = sets || (returns && time_ - lastSet < kMaxIdle && idleSteps_ < kIdleSteps);
    if ((nested && (!leaving || doubts_ > doubts)) || time_ <= roundStart ||
        timeline_.period > kMaxSeconds || timeline_.events.size() > kMaxEvents || !goesOn)
      break;
    if (!sets || nested) continue;
    if (!repetition.take(trackedState(), time_)) continue;
    timeline_.closed = true;
    timeline_.period = repetition.period();
    break;
  }
  return nested ? Flow::on : Flow::stop;
}

Reader::Flow Reader::numericFor(const Stat& stat) {
  const auto values = evaluateAll(stat.values, 0);
  const auto* from = values.size() > 0 ? values[0].as<double>() : nullptr;
  const auto* to = values.size() > 1 ? values[1].as<double>() : nullptr;
  const auto* step = values.size() > 2 ? values[2].as<double>() : nullptr;
  const double by = values.size() > 2 ? (step ? *step : 0) : 1;
  double rounds = 1;
  const bool known = from && to && by != 0 && std::isfinite((*to - *from) / by);
  if (known) rounds = std::floor((*to - *from) / by + 1e-9) + 1;
  const int count = int(std::clamp(rounds, 0.0, double(kMaxCount)));
  const double start = time_;
  const size_t before = timeline_.events.size();
  for (int i = 0; i < count; ++i) {
    const auto outer = scope_;
    scope_ = newScope(outer);
    scope_->names[stat.names[0]] = known ? Datum{*from + by * i} : Datum{};
    const Flow flow = walkRound(stat.blocks[0]);
    scope_ = outer;
    if (flow == Flow::leaveLoop) return Flow::on;
    if (flow != Flow::on) return flow;
  }
  if (!known && time_ > start) vague_ = true;
  // What the rounds that are not followed would do is lost.
  if (rounds > count && timeline_.events.size() > before) reading_.exhausted = true;
  if (rounds > count && count > 0)
    time_ = std::max(time_, std::min(start + (time_ - start) * rounds / count, kLatest));
  return Flow::on;
}

Reader::Flow Reader::genericFor(const Stat& stat) {
  const auto values = evaluateAll(stat.values, 0);
  const auto* library = values.empty() ? nullptr : values[0].as<Library>();
  const bool steps = library && library->name == "next";  // `in next, list`
  const auto* table = argument(values, steps ? 1 : 0).as<Table*>();
  const auto round = [&](Datum key, Datum value) {
    const auto outer = scope_;
    scope_ = newScope(outer);
    scope_->names[stat.names[0]] = std::move(key);
    if (stat.names.size() > 1) scope_->names[stat.names[1]] = std::move(value);
    const Flow flow = walkRound(stat.blocks[0]);
    scope_ = outer;
    return flow;
  };
  Flow flow = Flow::on;
  if (!table) {
    flow = round({}, {Stranger{"each"}});
  } else {
    Table* const items = *table;  // the body may change it
    const size_t count = items->items.size();
    for (size_t i = 0; i < count && i < items->items.size() && flow == Flow::on; ++i)
      flow = round({double(i + 1)}, items->items[i]);
    if (flow == Flow::on) spend(items->fields.size());  // they are copied
    const auto fields = flow == Flow::on ? items->fields : std::map<std::string, Datum>{};
    for (auto it = fields.begin(); it != fields.end() && flow == Flow::on; ++it)
      flow = round({it->first}, it->second);
  }
  return flow == Flow::leaveLoop ? Flow::on : flow;
}

}  // namespace obby::importer::luau
