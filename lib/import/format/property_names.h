// One spelling for each property, whatever the file's age and format: the engine's own name where
// it has one. So the level builder asks for "Size", never for "size"; "Color", never for
// "Color3uint8" or "BrickColor"; "Shape", "Health", "Part0" (of a WeldConstraint, too), "MeshId"
// (for MeshContent, too), "Scale" (of a Model).
#pragma once

#include <string>
#include <string_view>

#include "engine/document.h"

namespace obby::importer {

struct PropertySpelling {
  std::string name;     // normalised; empty: no level can depend on this property, drop it
  bool legacy = false;  // an older spelling: yields to the newer one when a file has both
};

// `name` as in the file.
PropertySpelling spellingOf(std::string_view className, std::string_view name);

// The value as the kind of `standard`, the property's default: palette numbers to colours, int for
// float and the like.
Value normalisedValue(const Value& standard, Value value);

}  // namespace obby::importer
