// The defaults behind class_defaults.h, one row each.
#pragma once

#include <span>
#include <string_view>

#include "engine/document.h"

namespace obby {

struct DefaultRow {
  std::string_view className, property;
  Value value;
};

std::span<const DefaultRow> defaultRows();

}  // namespace obby
