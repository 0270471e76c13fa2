// Loops of the script reader. Counted loops are followed round by round; endless ones until the
// parts they move are back where the loop began.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>

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

bool isWait(const Expr& expr) {
  return expr.kind == ExprKind::call || expr.kind == ExprKind::method;
}

// Conditions that nothing in the running game turns: literals, and waits, which always hold.
bool isFixed(const Expr& expr) {
  const auto& kids = expr.kids;
  switch (expr.kind) {
    case ExprKind::nil:
    case ExprKind::truth:
    case ExprKind::falsehood:
    case ExprKind::number:
    case ExprKind::string: return true;
    case ExprKind::unary:
    case ExprKind::binary:
      return std::all_of(kids.begin(), kids.end(),
                         [](const ExprPtr& kid) { return isFixed(*kid); });
    case ExprKind::call: return kids[0]->text == "wait";  // and task.wait
    case ExprKind::method: return expr.text == "Wait" || expr.text == "wait";
    default: return false;
  }
}

// "part.Transparency"; empty where it is anything but names.
std::string pathOf(const Expr& expr) {
  constexpr int kDeepest = 16;
  constexpr size_t kLongest = 100;  // of a name
  if (expr.height > kDeepest || expr.text.size() > kLongest) return {};
  if (expr.kind == ExprKind::name) return expr.text;
  if (expr.kind != ExprKind::field) return {};
  const std::string base = pathOf(*expr.kids[0]);
  return base.empty() ? base : base + "." + expr.text;
}

void collectPaths(const Expr& expr, std::set<std::string>& paths) {
  if (std::string path = pathOf(expr); !path.empty()) paths.insert(std::move(path));
  for (const ExprPtr& kid : expr.kids) collectPaths(*kid, paths);
}

bool asksClock(const std::set<std::string>& paths) {
  static constexpr const char* kClocks[] = {"tick", "time", "elapsedTime", "os.clock", "os.time"};
  return std::any_of(std::begin(kClocks), std::end(kClocks),
                     [&](const char* clock) { return paths.count(clock) > 0; });
}

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

// A loop that brings about its own end, as `while part.Transparency < 1 do` with a step in it, or
// waits for the clock.
Reader::Flow Reader::countingLoop(const Stat& stat, bool repeats) {
  for (int round = 0; round < kMaxCount; ++round) {
    const Truth goesOn = repeats ? Truth::yes : truthOf(evaluate(*stat.values[0]));
    if (goesOn == Truth::no) return Flow::on;
    const bool open = goesOn == Truth::unknown;
    if (open) ++unsure_;
    const Flow flow = walkRound(stat.blocks[0]);
    if (open) --unsure_;
    if (flow == Flow::leaveLoop) return Flow::on;
    if (flow != Flow::on || open) return flow;
    if (repeats && truthOf(evaluate(*stat.values[0])) != Truth::no) return Flow::on;
  }
  return Flow::on;
}

Reader::Flow Reader::whileLoop(const Stat& stat) {
  const Expr& condition = *stat.values[0];
  const bool repeats = stat.kind == StatKind::repeatLoop;
  std::set<std::string> paths;
  collectPaths(condition, paths);
  if (asksClock(paths) || (!paths.empty() && assigns(stat.blocks[0], paths)))
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
  if (time_ > start && timeline_.events.size() == event) endGoing();
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
// it does anything: its rounds are those that do.
Reader::Flow Reader::foreverLoop(const Block& body, const Expr* condition, bool sure) {
  const bool nested = timeline_.forever;
  const bool handler = timeline_.trigger == Trigger::frame && !nested;
  if (!nested) beginLoop();
  Repetition repetition;
  double lastSet = time_;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double roundStart = time_;
    const size_t event = timeline_.events.size(), budget = budget_;
    if (condition) evaluate(*condition);
    const Flow flow = walkRound(body);
    const bool returns = handler && flow == Flow::leaveFunction;
    if (timeline_.trigger == Trigger::frame) time_ = std::max(time_, roundStart + kFrame);
    const bool idle = round == 0 && flow == Flow::on && timeline_.events.size() == event;
    const bool leaves = flow == Flow::leaveFunction && !returns;
    const bool ends = flow == Flow::leaveLoop || leaves || (idle && !sure);
    if (ends) timeline_.forever = nested;
    if (ends) return leaves ? flow : Flow::on;
    timeline_.period = time_ - timeline_.loopStart;
    if (flow != Flow::on && !returns) return flow;
    const auto begin = timeline_.events.begin() + std::ptrdiff_t(event);
    const bool sets = std::any_of(begin, timeline_.events.end(), isTracked);
    if (sets) lastSet = time_;
    if (returns && !sets) idleSteps_ += budget - budget_;
    const bool goesOn = sets || (returns && time_ - lastSet < kMaxIdle && idleSteps_ < kIdleSteps);
    if (nested || time_ <= roundStart || timeline_.period > kMaxSeconds ||
        timeline_.events.size() > kMaxEvents || !goesOn)
      break;
    if (!sets) continue;
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
  if (rounds > count && count > 0) time_ = start + (time_ - start) * rounds / count;
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
