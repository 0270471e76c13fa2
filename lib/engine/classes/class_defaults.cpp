// Lookups in the class tables: a class is found once, then its chain of ancestors is walked.
#include "engine/classes/class_defaults.h"

#include <map>

#include "engine/classes/class_tables.h"

namespace obby {
namespace {

struct ClassInfo {
  const ClassInfo* parent = nullptr;
  std::map<std::string_view, Value> defaults;
};
using ClassIndex = std::map<std::string_view, ClassInfo>;

ClassIndex buildIndex() {
  ClassIndex index;
  for (const ClassRow& row : classRows()) {
    index[row.name].parent = row.parent.empty() ? nullptr : &index[row.parent];
  }
  for (const DefaultRow& row : defaultRows())
    index[row.className].defaults[row.property] = row.value;
  return index;
}

const ClassInfo* find(std::string_view className) {
  static const ClassIndex kIndex = buildIndex();
  const auto it = kIndex.find(className);
  if (it != kIndex.end()) return &it->second;
  static const ClassInfo* const kInstance = &kIndex.at("Instance");
  return kInstance;
}

template <class Number>
Value numberLike(Number number, const Value& like) {
  if (std::holds_alternative<double>(like)) return static_cast<double>(number);
  const bool whole = number >= Number(-9.0e18) && number <= Number(9.0e18);  // false for NaN, too
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
  if (className == ancestor) return true;
  const ClassInfo* wanted = find(ancestor);
  if (wanted == find("Instance")) return ancestor == "Instance";
  for (const ClassInfo* c = find(className); c != nullptr; c = c->parent) {
    if (c == wanted) return true;
  }
  return false;
}

const Value* defaultOf(std::string_view className, std::string_view property) {
  for (const ClassInfo* c = find(className); c != nullptr; c = c->parent) {
    if (const auto it = c->defaults.find(property); it != c->defaults.end()) return &it->second;
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
