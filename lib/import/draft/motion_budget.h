// Budgets the poses and ticks of all motions of a level.
#pragma once

#include <string>
#include <vector>

#include "import/draft/role_context.h"

namespace obby::importer {

// Max keys of all motions of a level together: 56 MB, and as much in its record. Their rounds
// together may have kMaxLevelRows ticks, the max of a level.
constexpr size_t kMaxLevelKeys = 1000000;

// Max seconds of a round, a turn or a wait in the simulator (level::maxTicks).
constexpr float kLongestMotion = 1200;

// Returns true if the budget covers all of the parts that a player can meet. A model's parts that
// can be met move together or not at all. Parts that stay still are noted.
bool fitsBudget(RoleContext& context, const std::vector<PartDraft*>& parts, const Motion& motion,
                const std::string& reason);

// Returns true if the budget covers one part. A part that cannot be met yet may still get a role,
// so parts beyond the budget are remembered.
bool partFitsBudget(RoleContext& context, const PartDraft& part, const Motion& motion,
                    const std::string& reason);
void spend(RoleContext& context, const PartDraft& part, const Motion& motion);

// Moves decoration, which players do not meet, as far as the remaining budget allows. Call it once,
// after all roles are known.
void settleMotions(RoleContext& context);

}  // namespace obby::importer
