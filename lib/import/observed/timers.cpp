// Finds parts that appear or vanish by themselves, and conveyors whose velocity scripts change.
#include <algorithm>
#include <cmath>
#include <map>

#include "import/observed/roles.h"

namespace obby::importer {
namespace {

constexpr double kSame = 0.05;  // seconds

using engine::Change;

// One moment at which a part appears or vanishes.
struct Turn {
  double time = 0;
  bool back = false, byCollision = false;
  engine::Line line;
};

// The times at which a part appears and vanishes.
struct Turns {
  std::vector<double> gone, back;
  std::vector<Turn> later;  // turns since the first probes that change its presence
  double last = 0;
  engine::Line line;
  bool collides = true, stands = true;  // current state
};

// Returns true if the change brings the part back, false if it takes it away, nullopt otherwise.
std::optional<bool> solidAfter(const Change& change) {
  if (change.property != "CanCollide" && change.property != "Parent") return std::nullopt;
  const bool* value = std::get_if<bool>(&change.value);
  return value ? std::optional(*value) : std::nullopt;
}

void addLater(Turns& turns, const Change& change, bool solid) {
  constexpr double kPlacing = 0.1;  // seconds for scripts to set up the place
  const bool byCollision = change.property == "CanCollide";
  if (byCollision && !turns.later.empty() && change.time < turns.later[0].time + kPlacing) return;
  bool& flag = byCollision ? turns.collides : turns.stands;
  if (turns.later.empty()) flag = !solid;
  const bool before = turns.collides && turns.stands;
  flag = solid;
  const bool now = turns.collides && turns.stands;
  if (before != now) turns.later.push_back({change.time, now, byCollision, change.line});
}

std::map<InstanceId, Turns> turnsOf(const engine::Report& report) {
  std::map<InstanceId, Turns> all;
  for (const Change& change : report.undisturbed.changes) {
    const auto solid = solidAfter(change);
    if (!solid) continue;
    Turns& turns = all[change.target];
    if (turns.line.script == kNoInstance) turns.line = change.line;
    (*solid ? turns.back : turns.gone).push_back(change.time);
    turns.last = change.time;
    if (change.time > report.probedAt) addLater(turns, change, *solid);
  }
  return all;
}

// Returns the regular interval of the last times, or nullopt if they are not regular.
std::optional<double> rhythmOf(const std::vector<double>& times) {
  if (times.size() < 3) return std::nullopt;
  const size_t last = times.size() - 1;
  const double period = times[last] - times[last - 1];
  if (std::abs(times[last - 1] - times[last - 2] - period) > kSame) return std::nullopt;
  return period;
}

// Gives a part its final state if it appears or vanishes only once.
void giveOnce(RoleContext& context, PartDraft& part, const Turn& turn) {
  Vanish vanish;
  vanish.timer = true;
  vanish.delay = float(turn.time);
  vanish.away = kGone;
  vanish.inverted = turn.back;
  part.vanish = vanish;
  part.solid = part.solid || turn.byCollision;
  if (turn.back && !part.anchored)
    context.level.noteUnmodelled(kComesLater, context.tree, part.id,
                                 "unanchored in the game; simulated as fixed where it appears; " +
                                     lineReason(context.tree, turn.line));
  part.evidence.push_back({"vanish", lineReason(context.tree, turn.line), false});
}

void giveTimer(RoleContext& context, PartDraft& part, const Turns& turns) {
  const auto period = rhythmOf(turns.gone);
  const std::string reason = lineReason(context.tree, turns.line);
  if (!period && turns.later.size() == 1) return giveOnce(context, part, turns.later.front());
  if (!period || turns.back.size() < 2) {
    context.level.noteUnmodelled("part that comes and goes irregularly", context.tree, part.id,
                                 "simulated as it is in the file; " + reason);
    return;
  }
  const double gone = turns.gone[turns.gone.size() - 2];
  const auto back = std::upper_bound(turns.back.begin(), turns.back.end(), gone);
  if (back == turns.back.end()) return;
  Vanish vanish;
  vanish.timer = true;
  vanish.away = float(*back - gone);
  vanish.delay = float(*period) - vanish.away;
  vanish.phase = float(*period - std::fmod(*back, *period));
  if (!(vanish.away > 0) || !(vanish.delay > 0)) return;
  part.solid = true;
  part.vanish = vanish;
  part.evidence.push_back({"vanish", reason, false});
}

}  // namespace

void timersFromObservation(RoleContext& context, const engine::Report& report) {
  for (const auto& [id, turns] : turnsOf(report)) {
    PartDraft* const part = context.part(id);
    if (part && turns.last > report.probedAt) giveTimer(context, *part, turns);
  }
  std::map<InstanceId, int> belts;
  for (const Change& change : report.undisturbed.changes)
    if (change.property == "Velocity" && change.time > report.probedAt &&
        ++belts[change.target] == 1)
      if (const PartDraft* const part = context.part(change.target); part && part->anchored)
        context.level.noteUnmodelled("conveyor that a script changes", context.tree, change.target,
                                     "simulated with its velocity at the start of play; " +
                                         lineReason(context.tree, change.line));
}

void broughtFromObservation(RoleContext& context, const ObservedPlace& place) {
  for (const InstanceId id : place.brought) {
    PartDraft* const part = context.part(id);
    if (!part || part->vanish) continue;
    part->vanish = Vanish{};  // it has no trigger
    part->vanish->inverted = true;
  }
}

}  // namespace obby::importer
