// Finds force fields, which protect players from TakeDamage and explosions.
#pragma once

#include <string>

#include "engine/report.h"
#include "import/roles/role.h"

namespace obby::importer {

// Returns the script line or spawn that gives players a temporary force field, or "" if none does.
std::string shieldIn(RoleContext& context, const engine::Report& report);

}  // namespace obby::importer
