// Force fields, which keep harm by TakeDamage and explosions from players.
#pragma once

#include <string>

#include "engine/report.h"
#include "import/roles/role.h"

namespace obby::importer {

// What gives players a force field for a time: a script's line, or a spawn. Empty: nothing does.
std::string shieldIn(RoleContext& context, const engine::Report& report);

}  // namespace obby::importer
