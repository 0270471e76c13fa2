// Values of properties and attributes as Rojo's files state them: plain JSON, whose kind the
// property tells, or an object {"Type": value}.
#pragma once

#include <optional>
#include <string_view>

#include "engine/document.h"
#include "import/rojo/json_file.h"

namespace obby::importer::rojo {

// Nothing for a kind that is not known, or where the JSON is not of it.
std::optional<Value> propertyValue(std::string_view className, std::string_view property,
                                   const Json& json);

std::optional<Value> attributeValue(const Json& json);

}  // namespace obby::importer::rojo
