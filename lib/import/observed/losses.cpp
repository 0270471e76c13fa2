// What was seen and is not in the level, and scripts that did not run to the end.
#include <algorithm>
#include <set>

#include "import/observed/effects_of.h"
#include "import/observed/roles.h"

namespace obby::importer {
namespace {

// Properties whose changes in play the level has no room for.
struct LossRow {
  const char* property;
  const char* kind;
  const char* note;
};
constexpr LossRow kLosses[] = {
    {"Gravity", "gravity that scripts change", "gravity stays as it is at the start"},
    {"WalkSpeed", "speed that scripts change", "the player's speed stays as it is at the start"},
    {"JumpPower", "speed that scripts change", "the player's jump stays as it is at the start"},
    {"JumpHeight", "speed that scripts change", "the player's jump stays as it is at the start"},
    {"Size", "size that scripts change", "stays as it is at the start"},
    {"CanTouch", "touch that scripts switch", "stays as it is at the start"},
    {"Anchored", "part that scripts let loose", "stays as it is at the start"},
};

// Moves a player who stands at the spawn.
bool isPush(const engine::Change& change) {
  const std::string& property = change.property;
  const bool isForce = property == "note lift" || property.rfind("note mover ", 0) == 0;
  const bool isSet = property == "CFrame" || property == "Velocity";
  return change.line.script != kNoInstance &&
         (isForce || (isSet && change.target == engine::kPlayer));
}

void noteLimbs(RoleContext& context, const engine::Report& report) {
  for (const engine::Change& change : report.undisturbed.changes)
    if (change.property == "note meets some limbs")
      context.level.noteUnmodelled(
          "collision group of some limbs", context.tree, change.target,
          "taken to collide with all of the body; " + lineReason(context.tree, change.line));
}

void noteLooks(RoleContext& context, const engine::Report& report) {
  for (const engine::Change& change : report.undisturbed.changes)
    if (change.property == "note looks")
      context.level.noteUnmodelled("place where scripts look for players", context.tree,
                                   kNoInstance,
                                   "no part is there; " + lineReason(context.tree, change.line));
}

// A player who has died may be put anywhere.
void notePushes(RoleContext& context, const engine::Report& report) {
  const auto& changes = report.undisturbed.changes;
  const auto push = std::find_if(changes.begin(), changes.end(), [&](const engine::Change& change) {
    return change.time > report.probedAt && isPush(change);
  });
  if (push != changes.end() && report.undisturbed.harms.empty())
    context.level.noteUnmodelled(
        "push without a touch", context.tree, kNoInstance,
        "the player stays where it is; " + lineReason(context.tree, push->line));
}

void noteAway(RoleContext& context, const engine::Report& report) {
  if (!report.away) return;
  const ProbeEffects effects = effectsOf(report, *report.away);
  if (effects.touchesPlayer())
    context.level.noteUnmodelled("script that acts on players away from parts", context.tree,
                                 kNoInstance,
                                 "it does nothing; " + lineReason(context.tree, effects.line()));
}

// Each new body gets the same speeds again.
bool isUsual(const engine::PlayerState& player, const engine::Change& change) {
  const double* const value = std::get_if<double>(&change.value);
  if (change.target != engine::kPlayer || !value) return false;
  return *value == (change.property == "WalkSpeed"   ? player.walkSpeed
                    : change.property == "JumpPower" ? player.jumpPower
                                                     : player.jumpHeight);
}

// Harm by these lines comes from parts, also where one of them moves into the player.
std::set<engine::Line> linesThatHarm(const engine::Report& report) {
  std::set<engine::Line> lines;
  for (const engine::Probe& probe : report.probes)
    if (!probe.lost)
      if (const auto harm = effectsOf(report, probe).harm) lines.insert(harm->line);
  return lines;
}

void noteChanges(RoleContext& context, const engine::Report& report) {
  std::set<std::pair<InstanceId, std::string>> named;
  for (const engine::Change& change : report.undisturbed.changes) {
    if (change.time <= report.probedAt || isUsual(report.arrived, change)) continue;
    for (const LossRow& row : kLosses)
      if (change.property == row.property && named.insert({change.target, change.property}).second)
        context.level.noteUnmodelled(
            row.kind, context.tree, change.target,
            std::string(row.note) + "; " + lineReason(context.tree, change.line));
  }
  const std::set<engine::Line> known = linesThatHarm(report);
  for (const engine::Harm& harm : report.undisturbed.harms)
    if (harm.hurts() && !known.contains(harm.line))
      return context.level.noteUnmodelled(
          "harm by itself", context.tree, kNoInstance,
          "no part deals it; " + lineReason(context.tree, harm.line));
}

}  // namespace

void noteObservedLosses(RoleContext& context, const ObservedPlace& place) {
  const Tree& tree = context.tree;
  const engine::Report& report = place.report;
  if (!report.failure.empty())
    context.level.noteUnmodelled("scripts that did not finish", tree, report.culprit,
                                 report.failure);
  for (const engine::Problem& problem : report.undisturbed.problems) {
    if (problem.script >= tree.size()) continue;
    if (problem.failure == engine::Failure::refused)
      context.level.noteIgnored("script that fails", tree.path(problem.script),
                                "in the game, too: " + problem.text);
    else
      context.level.noteUnmodelled("script that fails", tree, problem.script, problem.text);
  }
  if (report.sleeps)
    context.level.noteUnmodelled("script that still waits", tree, kNoInstance,
                                 "what comes later is not seen");
  noteChanges(context, report);
  notePushes(context, report);
  noteLooks(context, report);
  noteAway(context, report);
  noteLimbs(context, report);
  for (const auto& [what, count] : report.undisturbed.counts) {
    (void)count;
    context.level.noteIgnored("not in the twin of the engine", what, "does nothing");
  }
}

}  // namespace obby::importer
