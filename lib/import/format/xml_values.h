// The property elements of the XML format.
#pragma once

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

// What elements refer to.
struct XmlContext {
  std::unordered_map<std::string_view, std::shared_ptr<const std::string>> sharedStrings;
  std::unordered_map<std::string_view, InstanceId> instances;  // by referent
};

// All text and CDATA inside the element.
std::string textOf(pugi::xml_node element);

// The value of a property. The element's name is a hint only, as for the engine: `standard`, the
// default of the property, decides the kind where it is known (null where not). Errors have path
// ("X") and message, no place.
Result<Value> readXmlValue(pugi::xml_node element, const Value* standard,
                           const XmlContext& context);

}  // namespace obby::importer
