// The two properties that hold lists in one piece of bytes: attributes and tags.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/document.h"

namespace obby::importer {

struct DecodedAttributes {
  std::map<std::string, Value> values;
  std::string warning;  // empty if everything was read; otherwise why the rest was not
};

// Values carry no length, so an unknown kind ends the reading, as do more than 1000 attributes;
// what came before is kept.
DecodedAttributes decodeAttributes(std::string_view blob);

// Separated by NUL bytes; empty ones are skipped, and a tag counts once.
std::vector<std::string> decodeTags(std::string_view blob);

}  // namespace obby::importer
