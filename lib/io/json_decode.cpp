#include "io/json_decode.h"

#include <fmt/format.h>

#include <bitset>
#include <cmath>
#include <cstring>

#include "base/spelling.h"
#include "io/example.h"
#include "io/parse_all.h"

namespace obby::io {
namespace {

// Describes the values that a field accepts; for an object, with an example.
std::string expected(const TypePlan& type) {
  const bool isObject = type.kind == ValueKind::record && !type.record->tuple;
  return expectation(type) + (isObject ? " such as " + exampleOf(*type.record) : "");
}

using Type = JsonTree::Type;

constexpr size_t kMaxFields = 256;

void setTuple(const StructPlan& plan, capnp::DynamicStruct::Builder out,
              const capnp::DynamicValue::Reader* values) {
  for (size_t i = 0; i < plan.fields.size(); i++) out.set(plan.fields[i].field, values[i]);
}

}  // namespace

bool JsonDecoder::fill(const StructPlan& plan, capnp::DynamicStruct::Builder out, const Node& node,
                       const Path& path, std::string_view skip) {
  const bool emptyArray = node.type == Type::array && node.length == 0;  // Luau's empty table
  if (node.type != Type::object && !emptyArray)
    return fail(path, fmt::format("expected an object such as {}, found {}", exampleOf(plan),
                                  tree_.describe(node)));
  std::bitset<kMaxFields> seen;
  for (const Node& member : tree_.children(node)) {
    const std::string_view name = tree_.name(member);
    if (name == skip) continue;
    const FieldPlan* known = plan.find(name);
    const Path here{&path, name};
    if (!known) passOver(plan, here);
    if (!known || member.type == Type::null) continue;
    const size_t number = size_t(known - plan.fields.data());
    if (number < kMaxFields && seen[number]) return fail(here, "the field is given twice");
    if (number < kMaxFields) seen[number] = true;
    if (!field(*known, out, member, here)) return false;
  }
  return true;
}

// Ignores an unknown field: later minor versions add fields, and users add notes. Reports only
// names that look misspelt. The check is slow, so each name is checked once, up to a limit.
void JsonDecoder::passOver(const StructPlan& plan, const Path& path) {
  constexpr size_t kMax = 4, kMaxStrange = 1000;  // max numbers in a record
  if (misspelt_ == nullptr || misspelt_->size() == kMax || strange_.size() == kMaxStrange) return;
  std::pair<const StructPlan*, std::string> asked(&plan, path.name);
  if (strange_.contains(asked)) return;
  const std::string near = nearestName(path.name, plan.names());
  if (near.empty()) {
    strange_.insert(std::move(asked));
    return;
  }
  misspelt_->push_back(
      {{}, {}, path.text(), "unknown field, ignored", fmt::format("did you mean \"{}\"?", near)});
}

bool JsonDecoder::field(const FieldPlan& plan, capnp::DynamicStruct::Builder out, const Node& node,
                        const Path& path) {
  const TypePlan& type = plan.type;
  if (type.kind == ValueKind::record) {
    if (type.record->tuple) return tupleField(plan, out, node, path);
    if (!take(type.record->words(), path)) return false;
    return fill(*type.record, out.init(plan.field).as<capnp::DynamicStruct>(), node, path);
  }
  if (type.kind == ValueKind::list) {
    if (node.type != Type::array) return unexpected(type, node, path);
    if (node.length == 0) return true;
    if (!take(listWords(type.element[0], node.length), path)) return false;
    return list(type.element[0], out.init(plan.field, node.length).as<capnp::DynamicList>(), node,
                path);
  }
  if (type.kind == ValueKind::text) {
    if (node.type != Type::text) return unexpected(type, node, path);
    if (node.length == 0) return true;
    if (!take(textWords(node.length), path)) return false;
    auto text = out.init(plan.field, node.length).as<capnp::Text>();
    std::memcpy(text.begin(), tree_.text(node).data(), node.length);
    return true;
  }
  Value value;
  if (!scalar(type, node, path, value)) return false;
  out.set(plan.field, value);
  return true;
}

bool JsonDecoder::tupleField(const FieldPlan& plan, capnp::DynamicStruct::Builder out,
                             const Node& node, const Path& path) {
  const StructPlan& tuple = *plan.type.record;
  Tuple values;
  if (!readTuple(tuple, node, path, values)) return false;
  bool same = true;
  for (size_t i = 0; i < tuple.fields.size(); i++)
    same = same && numberBits(tuple.fields[i].type, values[i]) == plan.tupleDefault[i];
  if (same) return true;
  if (!take(tuple.words(), path)) return false;
  setTuple(tuple, out.init(plan.field).as<capnp::DynamicStruct>(), values.data());
  return true;
}

bool JsonDecoder::readTuple(const StructPlan& plan, const Node& node, const Path& path,
                            Tuple& out) {
  const size_t size = plan.fields.size();
  if (node.type != Type::array || node.length != size)
    return fail(path, fmt::format("expected {} numbers, found {}", size, tree_.describe(node)),
                plan.hint);
  size_t i = 0;
  for (const Node& number : tree_.children(node)) {
    const Path here{&path, {}, int64_t(i)};
    if (!scalar(plan.fields[i].type, number, here, out[i])) return false;
    i++;
  }
  return true;
}

bool JsonDecoder::list(const TypePlan& element, capnp::DynamicList::Builder out, const Node& node,
                       const Path& path) {
  uint32_t index = 0;
  for (const Node& each : tree_.children(node)) {
    const Path here{&path, {}, int64_t(index)};
    if (!elementValue(element, out, index++, each, here)) return false;
  }
  return true;
}

bool JsonDecoder::elementValue(const TypePlan& element, capnp::DynamicList::Builder out,
                               uint32_t index, const Node& node, const Path& path) {
  if (element.kind == ValueKind::record) {
    auto record = out[index].as<capnp::DynamicStruct>();
    if (!element.record->tuple) return fill(*element.record, record, node, path);
    Tuple values;
    if (!readTuple(*element.record, node, path, values)) return false;
    setTuple(*element.record, record, values.data());
    return true;
  }
  if (element.kind == ValueKind::text) {
    if (node.type != Type::text) return unexpected(element, node, path);
    if (node.length == 0) return true;
    if (!take(textWords(node.length), path)) return false;
    auto text = out.init(index, node.length).as<capnp::Text>();
    std::memcpy(text.begin(), tree_.text(node).data(), node.length);
    return true;
  }
  Value value;
  if (!scalar(element, node, path, value)) return false;
  out.set(index, value);
  return true;
}

bool JsonDecoder::scalar(const TypePlan& type, const Node& node, const Path& path, Value& out) {
  switch (type.kind) {
    case ValueKind::boolean:
      if (node.type != Type::yes && node.type != Type::no) return unexpected(type, node, path);
      out = Value(node.type == Type::yes);
      return true;
    case ValueKind::whole: return whole(type, node, path, out);
    case ValueKind::whole64: return whole64(type, node, path, out);
    case ValueKind::real32:
    case ValueKind::real64: return real(type, node, path, out);
    case ValueKind::name: return enumerant(type, node, path, out);
    default: return fail(path, "this list type has no JSON form");
  }
}

bool JsonDecoder::whole(const TypePlan& type, const Node& node, const Path& path, Value& out) {
  double value = 0;
  switch (node.type) {
    case Type::negative: value = double(int64_t(node.value)); break;
    case Type::whole: value = double(node.value); break;
    case Type::real:
      if (!parseAll(tree_.text(node), value)) return unexpected(type, node, path);
      break;
    default: return unexpected(type, node, path);
  }
  if (refuseWhole(type, value)) return unexpected(type, node, path);
  out = type.isSigned ? Value(int64_t(value)) : Value(uint64_t(value));
  return true;
}

bool JsonDecoder::whole64(const TypePlan& type, const Node& node, const Path& path, Value& out) {
  constexpr uint64_t kExact = uint64_t(1) << 53;
  if (node.type == Type::whole && node.value <= kExact) {
    out = type.isSigned ? Value(int64_t(node.value)) : Value(node.value);
    return true;
  }
  if (node.type == Type::negative && type.isSigned && -int64_t(node.value) <= int64_t(kExact)) {
    out = Value(int64_t(node.value));
    return true;
  }
  uint64_t positive = 0;
  int64_t any = 0;
  if (node.type == Type::text && !type.isSigned && parseAll(tree_.text(node), positive)) {
    out = Value(positive);
    return true;
  }
  if (node.type == Type::text && type.isSigned && parseAll(tree_.text(node), any)) {
    out = Value(any);
    return true;
  }
  return unexpected(type, node, path);
}

bool JsonDecoder::real(const TypePlan& type, const Node& node, const Path& path, Value& out) {
  const bool narrow = type.kind == ValueKind::real32;
  double wide = 0;
  float single = 0;
  if (node.type == Type::negative) {
    wide = double(int64_t(node.value));
    single = float(int64_t(node.value));
  } else if (node.type == Type::whole) {
    wide = double(node.value);
    single = float(node.value);
  } else if (node.type == Type::real) {
    if (!parseAll(tree_.text(node), wide)) wide = 0;  // below the smallest number
    // The text is converted again, because rounding twice can miss the nearest float.
    if (narrow && !parseAll(tree_.text(node), single)) single = float(wide);
  } else {
    return unexpected(type, node, path);
  }
  const double value = narrow ? double(single) : wide;
  if (auto wrong = refuseReal(type, value)) {
    if (!type.ranged || !std::isfinite(value))
      wrong = fmt::format("the number is too large: {}", tree_.describe(node));
    return fail(path, *wrong);
  }
  out = narrow ? Value(single) : Value(wide);
  return true;
}

bool JsonDecoder::enumerant(const TypePlan& type, const Node& node, const Path& path, Value& out) {
  if (node.type != Type::text) return unexpected(type, node, path);
  const std::string text(tree_.text(node));
  KJ_IF_MAYBE (found, type.names.findEnumerantByName(text.c_str())) {
    if (text.size() == found->getProto().getName().size()) {
      out = Value(capnp::DynamicEnum(*found));
      return true;
    }
  }
  for (const auto& [former, ordinal] : type.formerNames) {
    if (text != former) continue;
    out = Value(capnp::DynamicEnum(type.names, ordinal));
    return true;
  }
  const std::string near = nearestName(text, enumerants(type.names));
  return fail(path, fmt::format("expected {}, found {}", expected(type), tree_.describe(node)),
              near.empty() ? "" : fmt::format("did you mean \"{}\"?", near));
}

bool JsonDecoder::take(uint64_t words, const Path& path) {
  return budget_.take(words) || fail(path, WordBudget::kMessage);
}

bool JsonDecoder::unexpected(const TypePlan& type, const Node& node, const Path& path) {
  return fail(path, fmt::format("expected {}, found {}", expected(type), tree_.describe(node)));
}

bool JsonDecoder::fail(const Path& path, std::string message, std::string hint) {
  error = Error{{}, {}, path.text(), std::move(message), std::move(hint)};
  return false;
}

}  // namespace obby::io
