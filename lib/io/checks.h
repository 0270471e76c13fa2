// Decides which fields count as set, and which values no record may hold. Both codecs use these
// checks and their messages. Private to lib/io.
#pragma once

#include <capnp/dynamic.h>

#include <optional>
#include <string>
#include <string_view>

#include "io/schema_plan.h"

namespace obby::io {

// Returns "a number from 0 to 2000", "a whole number from 0 to 255", "true or false", ...
std::string expectation(const TypePlan& type);

// refuseReal() and refuseWhole() return nothing if `value` is valid for a field of this type,
// otherwise a message. Real numbers must be finite, and all numbers must be in range.
std::optional<std::string> refuseReal(const TypePlan& type, double value);
std::optional<std::string> refuseWhole(const TypePlan& type, double value);

// Returns true if a field differs from an absent one: numbers, names and tuples that differ from
// their default, texts and lists that are not empty, and structs that are present (a `kill` is set
// even if all its fields have their defaults).
bool isSet(const FieldPlan& field, capnp::DynamicStruct::Reader in);

// Returns nothing if the scalar or text is valid for a field of this type, otherwise a message.
// Structs and lists are always valid.
std::optional<std::string> refuseScalar(const TypePlan& type,
                                        const capnp::DynamicValue::Reader& value);

// Returns the names of the enumerants, in order.
std::vector<std::string> enumerants(const capnp::EnumSchema& names);

// Counts the words of a record in memory, and refuses more than kMaxMessageWords.
class WordBudget {
 public:
  bool take(uint64_t words) {
    left_ = words > left_ ? 0 : left_ - words;
    return left_ > 0;
  }
  static constexpr const char* kMessage = "the record is larger than the maximum of 256 MiB";

 private:
  uint64_t left_ = kMaxMessageWords;
};

inline uint64_t textWords(uint64_t bytes) { return bytes / 8 + 1; }
inline uint64_t listWords(const TypePlan& element, uint64_t count) {
  return element.record ? 1 + count * element.record->words()
                        : (count * element.elementBits + 63) / 64;
}

}  // namespace obby::io
