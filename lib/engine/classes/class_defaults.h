// Knows the defaults of properties that a file leaves out, and the base class of each class. The
// tables hold the classes that a level can depend on. Property names are the normalised ones of
// property_names.h.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "engine/document.h"

namespace obby {

// Returns true if `className` is `ancestor` or derives from it. A class outside the table derives
// from Instance alone.
bool isA(std::string_view className, std::string_view ancestor);

// Returns the class default of a property, inherited ones included, or null if the table has none.
const Value* defaultOf(std::string_view className, std::string_view property);

// Returns `value` as the kind of `like` if both are numbers of some kind, otherwise unchanged.
// Files say int where the class says float, and the other way round.
Value coerceTo(Value value, const Value& like);

// Returns the property as the file has it, else the class default, else T{}.
template <class T>
T get(const Instance& instance, const std::string& name) {
  if (const T* own = property<T>(instance, name)) return *own;
  const Value* fallback = defaultOf(instance.className, name);
  const T* value = fallback ? std::get_if<T>(fallback) : nullptr;
  return value ? *value : T{};
}

}  // namespace obby
