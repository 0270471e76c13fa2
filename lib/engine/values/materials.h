// What a part is made of: the engine's table of default physical properties.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/document.h"

namespace obby {

// By the value of the Material enum; an unknown material counts as Plastic (256).
PhysicalProperties materialProperties(uint32_t material);

// The value of the Material enum with that name.
std::optional<uint32_t> materialNamed(std::string_view name);

// As the engine calls it ("WoodPlanks"); empty for Plastic, which most parts are made of.
std::string_view materialName(uint32_t material);

}  // namespace obby
