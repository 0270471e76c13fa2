// Decodes the two properties that hold lists as bytes: attributes and tags.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/document.h"

namespace obby::importer {

struct DecodedAttributes {
  std::map<std::string, Value> values;
  std::string warning;  // empty if everything was read, else the reason why the rest was not
};

// Decodes the attributes of an instance. Values carry no length, so an unknown kind ends the
// reading. So do more than 1000 attributes. Attributes before that are kept.
DecodedAttributes decodeAttributes(std::string_view blob);

// Decodes tags separated by NUL bytes. Empty tags and duplicates are skipped.
std::vector<std::string> decodeTags(std::string_view blob);

}  // namespace obby::importer
