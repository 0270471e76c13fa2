// Notes observations that the level lacks, and scripts that did not run to the end.
#include <algorithm>
#include <set>

#include "engine/classes/class_defaults.h"
#include "import/document/assemblies.h"
#include "import/document/classes.h"
#include "import/observed/effects_of.h"
#include "import/observed/roles.h"
#include "import/observed/settle.h"

namespace obby::importer {
namespace {

constexpr const char* kLetGo = "part that scripts release";
constexpr const char* kStays = "simulated as it is at the start";

// Properties whose changes in play have no field in the level.
struct LossRow {
  const char* property;
  const char* kind;
  const char* note;
};
constexpr LossRow kLosses[] = {
    {"Gravity", "gravity that scripts change", "simulated with the gravity at the start"},
    {"WalkSpeed", "speed that scripts change", "simulated with the walk speed at the start"},
    {"JumpPower", "speed that scripts change", "simulated with the jump at the start"},
    {"JumpHeight", "speed that scripts change", "simulated with the jump at the start"},
    {"Size", "size that scripts change", kStays},
    {"CanTouch", "touch that scripts switch on or off", kStays},
    {"Anchored", kLetGo, kStays},
};

// Returns true for a part that scripts made and the document lacks.
bool isMadePart(InstanceId id) { return id >= engine::kMade && id < engine::kPlayer; }

// Returns true for a change that moves a player who stands at the spawn.
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
          "treated as colliding with the whole body; " + lineReason(context.tree, change.line));
}

void noteLooks(RoleContext& context, const engine::Report& report) {
  for (const engine::Change& change : report.undisturbed.changes)
    if (change.property == "note looks")
      context.level.noteUnmodelled(
          "region where scripts look for players", context.tree, kNoInstance,
          "not simulated, because no part marks it; " + lineReason(context.tree, change.line));
}

// Notes pushes of a living player. Scripts may put a dead one anywhere.
void notePushes(RoleContext& context, const engine::Report& report) {
  const auto& changes = report.undisturbed.changes;
  const auto push = std::find_if(changes.begin(), changes.end(), [&](const engine::Change& change) {
    return change.time > report.probedAt && isPush(change);
  });
  if (push != changes.end() && report.undisturbed.harms.empty())
    context.level.noteUnmodelled("push without a touch", context.tree, kNoInstance,
                                 "not simulated; " + lineReason(context.tree, push->line));
}

// Returns true for speeds that each new body gets again.
bool isUsual(const engine::PlayerState& player, const engine::Change& change) {
  const double* const value = std::get_if<double>(&change.value);
  if (change.target != engine::kPlayer || !value) return false;
  return *value == (change.property == "WalkSpeed"   ? player.walkSpeed
                    : change.property == "JumpPower" ? player.jumpPower
                                                     : player.jumpHeight);
}

// Returns the script lines that harm players. Parts do this harm, even if a part moves into a
// player who stands still.
std::set<engine::Line> linesThatHarm(const engine::Report& report) {
  std::set<engine::Line> lines;
  for (const engine::Probe& probe : report.probes)
    if (!probe.lost)
      if (const auto harm = effectsOf(report, probe).harm) lines.insert(harm->line);
  return lines;
}

// Notes parts that scripts make and remove again between two rounds of probes: no list contains
// them.
void noteComing(RoleContext& context, const engine::Report& report) {
  for (const engine::Change& change : report.undisturbed.changes) {
    const bool* const there = std::get_if<bool>(&change.value);
    const bool comes = change.property == "Parent" && there && *there;
    if (comes && change.time > report.probedAt && isMadePart(change.target))
      return context.level.noteUnmodelled(kComesLater, context.tree, kNoInstance,
                                          "a script adds it and removes it again; left out; " +
                                              lineReason(context.tree, change.line));
  }
}

// Returns true if unanchored parts fall because a joint vanishes while the parts at its ends stay.
bool letsFall(const RoleContext& context, const engine::Report& report,
              const engine::Change& change) {
  const bool* const there = std::get_if<bool>(&change.value);
  const Tree& tree = context.tree;
  if (!there || *there || change.target >= tree.size()) return false;
  if (change.property != "Parent" && change.property != "Enabled") return false;
  if (!isRigidJointClass(tree.at(change.target).className)) return false;
  const auto leaves = [&](InstanceId part) {
    const auto& changes = report.undisturbed.changes;
    return std::any_of(changes.begin(), changes.end(), [&](const engine::Change& other) {
      return other.target == part && other.property == "Parent" && other.time == change.time;
    });
  };
  const JointEnds ends = jointEnds(tree, change.target);
  for (const InstanceId end : {ends.first, ends.second})
    if (end < tree.size() && !get<bool>(tree.at(end), "Anchored") && !leaves(end)) return true;
  return false;
}

void noteChanges(RoleContext& context, const engine::Report& report) {
  std::set<std::pair<InstanceId, std::string>> named;
  const auto note = [&](const char* kind, const char* text, const engine::Change& change) {
    if (named.insert({change.target, change.property}).second)
      context.level.noteUnmodelled(
          kind, context.tree, change.target,
          std::string(text) + "; " + lineReason(context.tree, change.line));
  };
  for (const engine::Change& change : report.undisturbed.changes) {
    if (change.time <= report.probedAt || isUsual(report.arrived, change)) continue;
    if (isMadePart(change.target)) continue;  // noteComing() reports it
    if (change.time <= report.lookedAgainAt && isMadeLater(report, change.target)) continue;
    for (const LossRow& row : kLosses)
      if (change.property == row.property) note(row.kind, row.note, change);
    if (letsFall(context, report, change)) note(kLetGo, kStays, change);
  }
  const std::set<engine::Line> known = linesThatHarm(report);
  for (const engine::Harm& harm : report.undisturbed.harms)
    if (harm.hurts() && !known.contains(harm.line))
      return context.level.noteUnmodelled(
          "harm without a touch", context.tree, kNoInstance,
          "not simulated, as no part causes it; " + lineReason(context.tree, harm.line));
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
                                "it fails in the game, too: " + problem.text);
    else
      context.level.noteUnmodelled("script that fails", tree, problem.script, problem.text);
  }
  if (report.sleeps)
    context.level.noteUnmodelled("script still waiting at the end of the run", tree, kNoInstance,
                                 "the level lacks the effects after the wait");
  noteChanges(context, report);
  noteComing(context, report);
  notePushes(context, report);
  noteLooks(context, report);
  noteLimbs(context, report);
  for (const auto& [what, count] : report.undisturbed.counts) {
    (void)count;
    context.level.noteIgnored("not available when scripts ran", what,
                              "scripts got no result, an error or an endless wait");
  }
}

}  // namespace obby::importer
