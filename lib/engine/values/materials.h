// The engine's table of default physical properties of materials.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/document.h"

namespace obby {

// Returns the properties for a value of the Material enum. An unknown material counts as Plastic
// (256).
PhysicalProperties materialProperties(uint32_t material);

// Returns the value of the Material enum with that name.
std::optional<uint32_t> materialNamed(std::string_view name);

// Returns the engine's name ("WoodPlanks"), but "" for Plastic, the material of most parts.
std::string_view materialName(uint32_t material);

}  // namespace obby
