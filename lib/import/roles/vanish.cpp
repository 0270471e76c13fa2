// Parts that lose their collision for a while: on touch or by the clock.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/onset.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kVanishTags = {"disappearing",    "disappearingplatform",
                                                   "disappear",       "fadingplatform",
                                                   "fading",          "vanish",
                                                   "vanishing",       "fadeplatform",
                                                   "vanisher",        "disappearingpart",
                                                   "fallingplatform", "falling"};
constexpr float kDefaultDelay = 1, kDefaultAway = 3;
constexpr float kKitFade = 2, kKitAway = 1;        // tower kits before v6
constexpr float kKit6Blink = 0.2f, kKit6Away = 2;  // v6: three blinks, then away
constexpr double kKit6Count = 3;

void give(PartDraft& part, Vanish vanish, std::string reason, bool guessed) {
  if (part.vanish) return;
  vanish.delay = std::min(vanish.delay, kGone);
  vanish.away = std::min(vanish.away, kGone);
  part.vanish = vanish;
  part.evidence.push_back({"vanish", std::move(reason), guessed});
}

// Of several numbers the first that can be a time or a count.
std::optional<double> firstOf(const Tree& tree, InstanceId id,
                              std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const auto number = tree.number(id, name); number && *number >= 0) return number;
  return std::nullopt;
}

std::optional<double> delayOf(const Tree& tree, InstanceId id) {
  return firstOf(tree, id, {"FadeTime", "Delay", "DisappearDelay", "DisappearTime", "Time"});
}
std::optional<double> awayOf(const Tree& tree, InstanceId id) {
  return firstOf(tree, id,
                 {"RespawnTime", "ReturnTime", "ReappearTime", "AwayTime", "Cooldown", "OffTime"});
}

// The event after which the part no longer carries a player.
bool goesAway(const ScriptEvent& e) {
  if (e.kind == EventKind::destroy) return true;
  if (e.kind != EventKind::set || !e.flag) return false;
  return (e.property == "CanCollide" && !*e.flag) || (e.property == "Anchored" && !*e.flag);
}

// The event that undoes `gone`.
bool undoes(const ScriptEvent& e, const ScriptEvent& gone) {
  if (e.target != gone.target || e.property != gone.property) return false;
  return comesBack(e) || (e.kind == EventKind::set && e.property != "Parent" && e.flag == true);
}

void fromTouch(const Tree& tree, PartDraft& part, const Timeline& timeline,
               const ScriptReading& reading) {
  // What is delayed stands before what comes sooner.
  const ScriptEvent* gone = nullptr;
  for (const ScriptEvent& e : timeline.events)
    if (e.target == timeline.touched && goesAway(e) && (!gone || e.time < gone->time)) gone = &e;
  if (!gone || !part.solid) return;
  const ScriptEvent* back = nullptr;
  for (const ScriptEvent& e : timeline.events)
    if (undoes(e, *gone) && e.time > gone->time && (!back || e.time < back->time)) back = &e;
  Vanish vanish;
  vanish.delay = float(gone->time);
  vanish.away = back ? float(back->time - gone->time) : kGone;
  const bool falls = gone->property == "Anchored";
  give(part, vanish, scriptReason(tree, reading, gone->line) + (falls ? " (falls away)" : ""),
       falls || timeline.vague || timeline.maybe);
}

// What is out of the world does nothing: as a part without collision, if it is but solid.
bool vanishes(const PartDraft* part, const ScriptEvent& gone) {
  if (!part || part->vanish || !goesAway(gone)) return false;
  return gone.property == "CanCollide" || (gone.property == "Parent" && part->solid && !part->kill);
}

// An endless loop that switches the collision off and on, or takes the part out and puts it back.
void fromTimer(RoleContext& context, const ScriptReading& reading, const Timeline& timeline) {
  const auto first = timeline.events.begin() + std::ptrdiff_t(timeline.loopEvent);
  using Event = std::vector<ScriptEvent>::const_iterator;
  std::map<std::pair<InstanceId, std::string>, Event> backs;  // the first one of each
  for (Event gone = first; gone != timeline.events.end(); ++gone) {
    PartDraft* part = context.part(gone->target);
    if (!vanishes(part, *gone) || !(timeline.period > 0)) continue;
    const auto [known, isNew] = backs.try_emplace(std::pair(gone->target, gone->property));
    if (isNew)
      known->second = std::find_if(first, timeline.events.end(),
                                   [&](const ScriptEvent& e) { return undoes(e, *gone); });
    const Event back = known->second;
    if (back == timeline.events.end()) continue;
    const auto wrapped = [&](double t) {
      return t - std::floor(t / timeline.period + 1e-9) * timeline.period;
    };
    Vanish vanish;
    vanish.timer = true;
    vanish.away = float(wrapped(back->time - gone->time));
    vanish.delay = float(timeline.period) - vanish.away;
    vanish.phase = float(wrapped(-back->time));
    if (!(vanish.away > 0) || !(vanish.delay > 0)) continue;
    part->solid = true;  // the file may hold it in its away state
    give(*part, vanish, scriptReason(context.tree, reading, gone->line),
         gone->unsure || timeline.vague);
  }
}

void fromScripts(RoleContext& context, Doings doings) {
  const auto touch = [&](PartDraft& part, const Timeline& timeline, const ScriptReading& reading) {
    fromTouch(context.tree, part, timeline, reading);
  };
  context.eachTouch(doings, touch);
  context.eachTimeline(doings, [&](const ScriptReading& reading, const Timeline& timeline) {
    const bool endless = timeline.trigger == Trigger::start && timeline.forever;
    if (endless) fromTimer(context, reading, timeline);
  });
}

}  // namespace

void vanishFromTags(RoleContext& context) {
  context.eachTagged(kVanishTags, [&](InstanceId id, const std::string& tag) {
    const auto delay = delayOf(context.tree, id), away = awayOf(context.tree, id);
    for (PartDraft* part : context.partsOf(id)) {
      const auto ownDelay = delayOf(context.tree, part->id),
                 ownAway = awayOf(context.tree, part->id);
      Vanish vanish;
      vanish.delay = float(ownDelay ? *ownDelay : delay.value_or(kDefaultDelay));
      vanish.away = float(ownAway ? *ownAway : away.value_or(kDefaultAway));
      give(*part, vanish, "tag " + tag, !(delay || ownDelay) || !(away || ownAway));
    }
  });
}

void vanishFromMarkers(RoleContext& context) {
  const Tree& tree = context.tree;
  std::set<InstanceId> known;  // owners: of several markers the first counts
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    const bool vanisher = containsWord(markerWords(tree, marker), "vanisher");
    if (!vanisher && lower(tree.at(marker).name) != "fadetime") return;
    if (!known.insert(owner).second) return;
    Vanish vanish;
    if (vanisher) {
      const auto blinks = firstOf(tree, marker, {"BlinkCount"}).value_or(kKit6Count);
      vanish.delay = float(blinks) * kKit6Blink;
      vanish.away = float(firstOf(tree, marker, {"RespawnTime"}).value_or(kKit6Away));
    } else {
      vanish.delay = float(firstOf(tree, owner, {"FadeTime"}).value_or(kKitFade));
      vanish.away = float(firstOf(tree, owner, {"RespawnTime"}).value_or(kKitAway));
    }
    const std::string reason = "marker " + tree.at(marker).name;
    for (PartDraft* part : context.partsOf(owner))
      if (part->solid) give(*part, vanish, reason, false);
  });
}

void vanishFromScripts(RoleContext& context) {
  for (const Doings doings : kByCertainty) fromScripts(context, doings);
}

}  // namespace obby::importer
