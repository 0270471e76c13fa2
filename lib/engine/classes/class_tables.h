// The data behind class_defaults.h: one row a class, one row a default.
#pragma once

#include <span>
#include <string_view>

#include "engine/document.h"

namespace obby {

struct ClassRow {
  std::string_view name, parent;  // parent empty: the root class
};

struct DefaultRow {
  std::string_view className, property;
  Value value;
};

std::span<const ClassRow> classRows();
std::span<const DefaultRow> defaultRows();

}  // namespace obby
