// What a property is when the file leaves it out, and which class derives from which. The tables
// hold the classes that a level can depend on; property names are the normalised ones of
// property_names.h.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "engine/document.h"

namespace obby {

// True if `className` is `ancestor` or derives from it; a class that the table does not know
// derives from Instance alone.
bool isA(std::string_view className, std::string_view ancestor);

// The class default of a property, inherited ones included; null where the table has none.
const Value* defaultOf(std::string_view className, std::string_view property);

// `value` as the kind of `like` where both are numbers of some kind (files say int where the class
// says float, and the other way round); otherwise unchanged.
Value coerceTo(Value value, const Value& like);

// The property as the file has it, else the class default, else T{}.
template <class T>
T get(const Instance& instance, const std::string& name) {
  if (const T* own = property<T>(instance, name)) return *own;
  const Value* fallback = defaultOf(instance.className, name);
  const T* value = fallback ? std::get_if<T>(fallback) : nullptr;
  return value ? *value : T{};
}

}  // namespace obby
