#include "solve/report/part_text.h"

#include <fmt/format.h>

#include "level/select_parts.h"

namespace obby::solve {

std::string partText(schema::Level::Reader level, uint32_t part) {
  const auto parts = level.getParts();
  const std::string number = fmt::format("part {}", part);
  if (part >= parts.size() || parts[part].getName().size() == 0) return number;
  level::PartIndex index(level);
  const std::string selector = level::selectorOf(index, part);
  if (!selector.starts_with("part:")) return fmt::format("'{}'", selector);
  return fmt::format("'{}' ({})", parts[part].getName().cStr(), number);
}

}  // namespace obby::solve
