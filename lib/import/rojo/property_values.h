// Reads values of properties and attributes from Rojo's files: plain JSON, whose kind follows from
// the property, or an object {"Type": value}.
#pragma once

#include <optional>
#include <string_view>

#include "engine/document.h"
#include "import/rojo/json_file.h"

namespace obby::importer::rojo {

// Returns the value of a property, or nullopt if its kind is unknown or the JSON does not match it.
std::optional<Value> propertyValue(std::string_view className, std::string_view property,
                                   const Json& json);

std::optional<Value> attributeValue(const Json& json);

}  // namespace obby::importer::rojo
