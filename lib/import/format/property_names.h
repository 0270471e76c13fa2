// Gives each property one spelling for files of all ages and formats: the engine's own name where
// it has one. So the level builder asks for "Size", never for "size"; for "Color", never for
// "Color3uint8" or "BrickColor". Other names are "Shape", "Health", "Part0" (also of a
// WeldConstraint), "MeshId" (also for MeshContent) and "Scale" (of a Model).
#pragma once

#include <string>
#include <string_view>

#include "engine/document.h"

namespace obby::importer {

struct PropertySpelling {
  std::string name;     // normalised name; empty if no level can depend on this property
  bool legacy = false;  // An older spelling. It yields to the newer one if a file has both.
};

// Returns the spelling of `name`, the property's name in the file.
PropertySpelling spellingOf(std::string_view className, std::string_view name);

// Converts the value to the kind of `standard`, the property's default: palette numbers to colours,
// int to float and the like.
Value normalisedValue(const Value& standard, Value value);

}  // namespace obby::importer
