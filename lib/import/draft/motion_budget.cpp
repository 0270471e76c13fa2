// Budgets motions. Parts that a player can meet come first, then the others.
#include "import/draft/motion_budget.h"

#include <algorithm>
#include <utility>

#include "level/compile_parts.h"

namespace obby::importer {
namespace {

// Returns the ticks of one round through the keys, and of the wait before a single round. The
// simulator's table has at least as many rows.
size_t ticksOf(const Motion& motion) {
  constexpr float kRate = 60;  // ticks a second
  constexpr float kMax = 2 * kLongestMotion * kRate;
  if (motion.keys.size() < 2) return 1;
  const float rounds = motion.repeat == Repeat::pingPong ? 2 : 1;
  const float wait = motion.repeat == Repeat::once ? std::max(0.0f, -motion.offset) : 0;
  const float round = (motion.keys.back().time - motion.keys.front().time) * rounds;
  const float ticks = (round + wait) * kRate;
  return ticks >= 1 ? size_t(std::min(ticks, kMax)) : 1;
}

// Returns true if a player can meet the part, by its roles so far. The simulator ignores all other
// parts.
bool isMet(const PartDraft& part) {
  const bool acts = part.kill || part.jumpPad || part.teleport || part.vanish || part.seat;
  return part.solid || (part.touch && acts) || part.checkpoint || part.goal;
}

// Each part has its own keys and table. A level beyond these limits would be rejected as a whole.
bool fits(const MotionBudget& budget, size_t parts, const Motion& motion) {
  return parts * motion.keys.size() <= kMaxLevelKeys - budget.keys &&
         parts * ticksOf(motion) <= level::kMaxLevelRows - budget.ticks;
}

void take(MotionBudget& budget, const Motion& motion) {
  budget.keys += motion.keys.size();
  budget.ticks += ticksOf(motion);
}

void noteTooMany(RoleContext& context, InstanceId part, const std::string& reason) {
  context.level.noteUnmodelled("motion with too many poses", context.tree, part,
                               "the level's motions have more than " +
                                   std::to_string(kMaxLevelKeys) + " poses or " +
                                   std::to_string(level::kMaxLevelRows) +
                                   " ticks; the part stays at its position in the file; " + reason);
}

void stop(RoleContext& context, PartDraft& part) {
  std::string reason;
  std::erase_if(part.evidence, [&](const Evidence& e) {
    if (e.role == "motion") reason = e.reason;
    return e.role == "motion";
  });
  part.motion.reset();
  context.unmetStill.try_emplace(part.id, std::move(reason));
}

}  // namespace

bool fitsBudget(RoleContext& context, const std::vector<PartDraft*>& parts, const Motion& motion,
                const std::string& reason) {
  const auto met =
      std::count_if(parts.begin(), parts.end(), [](const auto* part) { return isMet(*part); });
  if (fits(context.metBudget, size_t(met), motion)) return true;
  for (const PartDraft* part : parts)
    if (isMet(*part)) noteTooMany(context, part->id, reason);
  return false;
}

bool partFitsBudget(RoleContext& context, const PartDraft& part, const Motion& motion,
                    const std::string& reason) {
  // fitsBudget has checked the met parts.
  if (isMet(part) || fits(context.unmetBudget, 1, motion)) return true;
  context.unmetStill.try_emplace(part.id, reason);
  return false;
}

void spend(RoleContext& context, const PartDraft& part, const Motion& motion) {
  const bool met = isMet(part);
  take(met ? context.metBudget : context.unmetBudget, motion);
  if (!met) context.unmetMoving.push_back(part.id);
}

void settleMotions(RoleContext& context) {
  for (const bool met : {true, false})
    for (const InstanceId id : context.unmetMoving) {
      PartDraft* part = context.part(id);
      if (!part || !part->motion || isMet(*part) != met) continue;
      if (fits(context.metBudget, 1, *part->motion))
        take(context.metBudget, *part->motion);
      else
        stop(context, *part);
    }
  for (const auto& [id, reason] : context.unmetStill) {
    const PartDraft* part = context.part(id);
    if (!part || part->motion) continue;  // it got another motion, which fits the budget
    if (isMet(*part))
      noteTooMany(context, id, reason);
    else
      context.level.noteIgnored("moving decoration", context.tree.path(id),
                                "players never touch it, and the level has reached its limit on "
                                "motion data; the part stays at its position in the file; " +
                                    reason);
  }
}

}  // namespace obby::importer
