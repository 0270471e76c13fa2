// The schema as tables, which are made once, so that both codecs process records without asking the
// schema loader for every field. Private to lib/io.
#pragma once

#include <capnp/dynamic.h>
#include <capnp/schema.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace obby::io {

struct StructPlan;

enum class ValueKind : uint8_t {
  boolean,
  whole,
  whole64,
  real32,
  real64,
  text,
  name,
  record,
  list
};

// The type of a field or of a list's elements.
struct TypePlan {
  ValueKind kind = ValueKind::boolean;
  bool isSigned = false;     // whole, whole64
  double min = 0, max = 0;   // whole, real: limits of the type or of $range
  bool ranged = false;       // $range narrows the type
  uint32_t elementBits = 0;  // size of one list element; 0 for records
  const StructPlan* record = nullptr;
  capnp::EnumSchema names;                                    // name
  std::vector<std::pair<std::string, uint16_t>> formerNames;  // name: $formerly and the ordinal
  std::vector<TypePlan> element;                              // list: exactly one
  capnp::Type type;
};

struct FieldPlan {
  std::string name;
  capnp::StructSchema::Field field;
  TypePlan type;
  bool always = false;   // written to JSON even if it has its default
  std::string example;   // a value in JSON; may be empty
  std::string formerly;  // $formerly; may be empty
  // Bits of each number of the default, if the field is a tuple.
  std::vector<uint64_t> tupleDefault;
};

struct StructPlan {
  capnp::StructSchema schema;
  bool tuple = false;  // written in JSON as an array of its numbers
  std::string hint;    // the form of its value, shown in errors; may be empty
  uint32_t dataWords = 0, pointers = 0;
  std::vector<FieldPlan> fields;
  std::unordered_map<std::string_view, size_t> byName;  // former names, too

  uint32_t words() const { return dataWords + pointers; }
  const FieldPlan* find(std::string_view name) const;  // finds a field by its name or a former name
  std::vector<std::string> names() const;              // present names of the fields
};

// Returns the plan of schema::Record, whose fields are the kinds.
const StructPlan& recordPlan();
// Returns the plan of another struct. Plans live as long as the program.
const StructPlan& planOf(capnp::StructSchema schema);

// Returns the bits of one number of a tuple, to compare values exactly (-0 is not 0).
uint64_t numberBits(const TypePlan& type, const capnp::DynamicValue::Reader& value);

// Returns true if `value`, of a tuple type, has exactly the numbers `bits`.
bool tupleEquals(const StructPlan& plan, capnp::DynamicStruct::Reader value,
                 const std::vector<uint64_t>& bits);

// Max size of one message; larger ones are neither read nor written.
inline constexpr uint64_t kMaxMessageWords = (uint64_t(256) << 20) / 8;
inline constexpr int kMaxNesting = 64;

}  // namespace obby::io
