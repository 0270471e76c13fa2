// What was seen and is not in the level, and scripts that did not run to the end.
#include "import/observed/roles.h"

#include <set>

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
    {"CollisionGroup", "collision group that scripts change", "stays as it is at the start"},
    {"Anchored", "part that scripts let loose", "stays as it is at the start"},
};

// Each new body gets the same speeds again.
bool isUsual(const engine::PlayerState& player, const engine::Change& change) {
  const double* const value = std::get_if<double>(&change.value);
  if (change.target != engine::kPlayer || !value) return false;
  return *value == (change.property == "WalkSpeed"   ? player.walkSpeed
                    : change.property == "JumpPower" ? player.jumpPower
                                                     : player.jumpHeight);
}

void noteChanges(RoleContext& context, const engine::Report& report) {
  std::set<std::pair<InstanceId, std::string>> named;
  for (const engine::Change& change : report.undisturbed.changes) {
    if (change.time <= report.probedAt || isUsual(report.arrived, change)) continue;
    for (const LossRow& row : kLosses)
      if (change.property == row.property && named.insert({change.target, change.property}).second)
        context.level.noteUnmodelled(
            row.kind, change.target < context.tree.size() ? context.tree.path(change.target) : "",
            std::string(row.note) + "; " + lineReason(context.tree, change.line));
  }
  for (const engine::Harm& harm : report.undisturbed.harms)
    if (harm.hurts())
      return context.level.noteUnmodelled(
          "harm by itself", "", "no part deals it; " + lineReason(context.tree, harm.line));
}

}  // namespace

void noteObservedLosses(RoleContext& context, const ObservedPlace& place) {
  const Tree& tree = context.tree;
  const engine::Report& report = place.report;
  if (!report.failure.empty())
    context.level.noteUnmodelled("scripts that did not finish",
                                 report.culprit < tree.size() ? tree.path(report.culprit) : "",
                                 report.failure);
  for (const engine::Problem& problem : report.undisturbed.problems) {
    if (problem.script >= tree.size()) continue;
    context.level.noteUnmodelled("script that fails", tree.path(problem.script), problem.text);
  }
  noteChanges(context, report);
  for (const auto& [what, count] : report.undisturbed.counts) {
    (void)count;
    context.level.noteIgnored("not in the twin of the engine", what, "does nothing");
  }
}

}  // namespace obby::importer
