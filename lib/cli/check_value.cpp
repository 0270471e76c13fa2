#include "cli/check_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/spelling.h"
#include "io/parse_all.h"
#include "io/text.h"

namespace obby::cli {
namespace {

bool contains(const std::vector<std::string>& choices, const std::string& text) {
  return std::find(choices.begin(), choices.end(), text) != choices.end();
}

// Returns " from 0 to 16", " of at least 0", "", ...
std::string bounds(const OptionRow& row) {
  const bool low = row.min > std::numeric_limits<double>::lowest();
  const bool high = row.max < std::numeric_limits<double>::max();
  if (low && high) return fmt::format(" from {} to {}", row.min, row.max);
  if (low) return fmt::format(" of at least {}", row.min);
  return high ? fmt::format(" of at most {}", row.max) : std::string();
}

std::string multiples(const OptionRow& row) {
  return row.multiple > 1 ? fmt::format(" that is a multiple of {}", row.multiple) : std::string();
}

std::optional<std::string> checkFlag(std::string& text) {
  const bool yes = contains({"true", "1", "yes", "on"}, text);
  if (!yes && !contains({"false", "0", "no", "off"}, text))
    return "expected true or false, found " + io::quoted(text);
  text = yes ? "true" : "false";
  return std::nullopt;
}

std::optional<std::string> checkChoice(const OptionRow& row, const std::string& text) {
  if (contains(row.choices, text)) return std::nullopt;
  std::string out =
      fmt::format("expected one of {}, found {}", fmt::join(row.choices, ", "), io::quoted(text));
  const std::string near = nearestName(text, row.choices);
  return near.empty() ? out : fmt::format("{} (did you mean {}?)", out, near);
}

}  // namespace

std::optional<std::string> checkValue(const OptionRow& row, std::string& text) {
  const auto expected = [&](const std::string& what) {
    return fmt::format("expected {}, found {}", what, io::quoted(text));
  };
  switch (row.type) {
    case ValueType::flag: return checkFlag(text);
    case ValueType::text:
    case ValueType::file: return std::nullopt;
    case ValueType::integer: {
      int64_t value = 0;
      if (!io::parseAll(text, value) || double(value) < row.min || double(value) > row.max ||
          value % row.multiple != 0)
        return expected("a whole number" + bounds(row) + multiples(row));
      return std::nullopt;
    }
    case ValueType::number: {
      double value = 0;
      if (!io::parseAll(text, value) || !std::isfinite(value) || value < row.min || value > row.max)
        return expected("a number" + bounds(row));
      return std::nullopt;
    }
    case ValueType::seed: {
      uint64_t value = 0;
      if (!io::parseAll(text, value)) return expected("a whole number from 0 to 2^64 - 1");
      return std::nullopt;
    }
    case ValueType::choice:
    case ValueType::mode: return checkChoice(row, text);
  }
  return std::nullopt;
}

std::string valueLabel(const OptionRow& row) {
  if (row.type == ValueType::flag) return {};
  if (!row.value.empty() || row.choices.empty()) return row.value.empty() ? "VALUE" : row.value;
  return fmt::format("{}", fmt::join(row.choices, "|"));
}

}  // namespace obby::cli
