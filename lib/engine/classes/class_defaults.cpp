// Looks up defaults along the chain of base classes.
#include "engine/classes/class_defaults.h"

#include <map>

#include "engine/classes/class_table.h"
#include "engine/classes/default_rows.h"

namespace obby {
namespace {

using Defaults = std::map<std::string_view, Value>;

const std::map<std::string_view, Defaults>& allDefaults() {
  static const std::map<std::string_view, Defaults> kAll = [] {
    std::map<std::string_view, Defaults> all;
    for (const DefaultRow& row : defaultRows()) all[row.className][row.property] = row.value;
    return all;
  }();
  return kAll;
}

constexpr std::string_view kRoot = "Instance";

// Returns the class from which `className` derives, or "" for the root and unknown classes.
std::string_view baseOf(std::string_view className) {
  if (className == kRoot) return {};
  const std::string_view* const base = engine::ClassTable::get().baseOf(className);
  return base ? *base : kRoot;
}

template <class Number>
Value numberLike(Number number, const Value& like) {
  if (std::holds_alternative<double>(like)) return static_cast<double>(number);
  const bool whole = number >= Number(-9.0e18) && number <= Number(9.0e18);  // rejects NaN, too
  if (!whole) return number;
  if (std::holds_alternative<int64_t>(like)) return static_cast<int64_t>(number);
  if (std::holds_alternative<bool>(like)) return number != Number(0);
  if (std::holds_alternative<EnumItem>(like) && number >= 0 && number <= Number(0x7fffffff)) {
    return EnumItem{static_cast<uint32_t>(number), {}};
  }
  return number;
}

}  // namespace

bool isA(std::string_view className, std::string_view ancestor) {
  for (; !className.empty(); className = baseOf(className))
    if (className == ancestor) return true;
  return false;
}

const Value* defaultOf(std::string_view className, std::string_view property) {
  for (; !className.empty(); className = baseOf(className)) {
    const auto own = allDefaults().find(className);
    if (own == allDefaults().end()) continue;
    if (const auto it = own->second.find(property); it != own->second.end()) return &it->second;
  }
  return nullptr;
}

Value coerceTo(Value value, const Value& like) {
  if (value.index() == like.index()) return value;
  if (const auto* whole = std::get_if<int64_t>(&value)) return numberLike(*whole, like);
  if (const auto* real = std::get_if<double>(&value)) return numberLike(*real, like);
  if (const auto* item = std::get_if<EnumItem>(&value)) {
    return numberLike(static_cast<int64_t>(item->value), like);
  }
  if (const auto* truth = std::get_if<bool>(&value)) return numberLike(int64_t{*truth}, like);
  return value;
}

}  // namespace obby
