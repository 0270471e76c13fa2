// Reads the property elements of the XML format.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

// The tables that elements refer to.
struct XmlContext {
  std::unordered_map<std::string_view, std::shared_ptr<const std::string>> sharedStrings;
  std::unordered_map<std::string_view, InstanceId> instances;  // instances by referent
};

// Returns all text and CDATA inside the element.
std::string textOf(pugi::xml_node element);

// Returns the value of a property. `standard`, the default of the property, decides its kind; null
// if unknown. As in the engine, the element's name is only a hint. Errors have a path ("X") and a
// message, but no place.
Result<Value> readXmlValue(pugi::xml_node element, const Value* standard,
                           const XmlContext& context);

}  // namespace obby::importer
