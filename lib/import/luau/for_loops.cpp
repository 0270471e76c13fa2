// For loops of the script reader, followed round by round.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "import/frame_time.h"
#include "import/luau/conditions.h"
#include "import/luau/reader.h"
#include "import/motion_room.h"

namespace obby::importer::luau {
namespace {

constexpr double kLatest = 1e9;           // seconds: later than anything that counts
constexpr double kMany = 24 * 3600 * 60;  // rounds: a day of frames, as good as endless

// Seconds that each round waits, as far as its own lines state it.
double statedWait(const Block& body) {
  double seconds = 0;
  for (const StatPtr& stat : body) {
    if (stat->kind != StatKind::call || stat->values[0]->kind != ExprKind::call) continue;
    const auto& kids = stat->values[0]->kids;
    const std::string path = pathOf(*kids[0]);
    if (path != "wait" && path != "task.wait") continue;
    const bool stated = kids.size() > 1 && kids[1]->kind == ExprKind::number;
    seconds += std::max(stated ? kids[1]->number : 0.0, kFrame);
  }
  return seconds;
}

// Whether it has too many rounds to follow each, and goes on for longer than a motion can: its end
// is as good as never.
bool outlasts(const Block& body, double rounds) {
  return rounds > kMaxCount && rounds * statedWait(body) > double(kLongestMotion);
}

}  // namespace

// `for i = 1, math.huge do`, or a count that takes long, with no way out. One that has an end,
// however late, and does nothing but wait is passed over.
Reader::Flow Reader::endlessFor(const Stat& stat, double from, double by, double rounds) {
  const bool nested = timeline_.forever;
  const double start = time_;
  const auto outer = scope_;
  const auto begins = [&](int round) {
    scope_ = newScope(outer);
    scope_->names[stat.names[0]] = {from + by * round};
    return true;
  };
  const Flow flow = foreverLoop(stat.blocks[0], begins, std::isinf(rounds));
  scope_ = outer;
  if (flow == Flow::on && !nested && time_ > start)
    time_ = std::min(start + (time_ - start) * rounds, kLatest);
  return flow;
}

// One that counts for ever and has a way out is followed until it takes that, or may.
Reader::Flow Reader::numericFor(const Stat& stat) {
  const auto values = evaluateAll(stat.values, 0);
  const auto* from = values.size() > 0 ? values[0].as<double>() : nullptr;
  const auto* to = values.size() > 1 ? values[1].as<double>() : nullptr;
  const auto* step = values.size() > 2 ? values[2].as<double>() : nullptr;
  const double by = values.size() > 2 ? (step ? *step : 0) : 1;
  const double span = from && to && by != 0 ? (*to - *from) / by : std::nan("");
  const bool known = !std::isnan(span), endless = known && span > kMany;
  const double rounds = known ? std::floor(span + 1e-9) + 1 : 1;
  const bool stays = endless || (!timeline_.forever && outlasts(stat.blocks[0], rounds));
  if (stays && !canLeave(stat.blocks[0], false)) return endlessFor(stat, *from, by, span);
  const int count = int(std::clamp(rounds, 0.0, double(kMaxCount)));
  const double start = time_;
  const size_t before = timeline_.events.size(), doubts = doubts_;
  for (int i = 0; i < count; ++i) {
    const auto outer = scope_;
    scope_ = newScope(outer);
    scope_->names[stat.names[0]] = known ? Datum{*from + by * i} : Datum{};
    const Flow flow = walkRound(stat.blocks[0]);
    scope_ = outer;
    if (flow == Flow::leaveLoop) return Flow::on;
    if (flow != Flow::on) return flow;
    if (!endless || doubts_ == doubts) continue;
    await();
    if (time_ > start) vague_ = true;
    return Flow::on;
  }
  if (!known && time_ > start) vague_ = true;
  // What the rounds that are not followed would do is lost.
  if (rounds > count && timeline_.events.size() > before) reading_.exhausted = true;
  if (rounds > count && time_ > start)
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
      if (!it->second.as<Nil>()) flow = round({it->first}, it->second);
  }
  return flow == Flow::leaveLoop ? Flow::on : flow;
}

}  // namespace obby::importer::luau
