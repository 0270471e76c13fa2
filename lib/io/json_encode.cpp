#include "io/json_encode.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/checks.h"
#include "io/text.h"
#include "io/values.h"

namespace obby::io {

bool JsonEncoder::record(capnp::DynamicStruct::Reader record) {
  KJ_IF_MAYBE (kind, record.which()) {
    const Path path;
    const FieldPlan& plan = recordPlan().fields[kind->getIndex()];
    out += "{\"type\":\"" + plan.name + '"';
    bool first = false;
    if (!fields(*plan.type.record, record.get(*kind).as<capnp::DynamicStruct>(), path, first))
      return false;
    out += '}';
    return true;
  }
  error = makeError("cannot write a record of a kind that this program lacks as JSON");
  return false;
}

void JsonEncoder::member(std::string_view name, bool& first) {
  if (!first) out += ',';
  first = false;
  out += '"';
  out += name;
  out += "\":";
}

bool JsonEncoder::fields(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path,
                         bool& first) {
  for (const FieldPlan& field : plan.fields) {
    if (!field.always && !isSet(field, in)) continue;
    member(field.name, first);
    const Path here{&path, field.name};
    if (!value(field.type, in.get(field.field), here)) return false;
  }
  return true;
}

bool JsonEncoder::object(const StructPlan& plan, capnp::DynamicStruct::Reader in,
                         const Path& path) {
  if (plan.tuple) return tuple(plan, in, path);
  bool first = true;
  out += '{';
  if (!fields(plan, in, path, first)) return false;
  out += '}';
  return true;
}

bool JsonEncoder::tuple(const StructPlan& plan, capnp::DynamicStruct::Reader in, const Path& path) {
  out += '[';
  for (size_t i = 0; i < plan.fields.size(); i++) {
    if (i > 0) out += ',';
    const Path here{&path, {}, int64_t(i)};
    if (!value(plan.fields[i].type, in.get(plan.fields[i].field), here)) return false;
  }
  out += ']';
  return true;
}

bool JsonEncoder::list(const TypePlan& element, capnp::DynamicList::Reader in, const Path& path) {
  out += '[';
  for (uint32_t i = 0; i < in.size(); i++) {
    if (i > 0) out += ',';
    const Path here{&path, {}, int64_t(i)};
    if (!value(element, in[i], here)) return false;
  }
  out += ']';
  return true;
}

bool JsonEncoder::value(const TypePlan& type, const capnp::DynamicValue::Reader& in,
                        const Path& path) {
  if (auto wrong = refuseScalar(type, in)) return fail(path, *wrong);
  switch (type.kind) {
    case ValueKind::boolean: out += in.as<bool>() ? "true" : "false"; return true;
    case ValueKind::whole:
    case ValueKind::whole64: {
      const char* quote = type.kind == ValueKind::whole64 ? "\"" : "";
      out += quote;
      out += type.isSigned ? fmt::to_string(in.as<int64_t>()) : fmt::to_string(in.as<uint64_t>());
      out += quote;
      return true;
    }
    case ValueKind::real32:
    case ValueKind::real64: return real(type, in.as<double>(), path);
    case ValueKind::text: {
      const auto text = in.as<capnp::Text>();
      appendJsonString(out, std::string_view(text.begin(), text.size()));
      return true;
    }
    case ValueKind::name: {
      KJ_IF_MAYBE (name, in.as<capnp::DynamicEnum>().getEnumerant()) {
        out += '"';
        out += name->getProto().getName().cStr();
        out += '"';
      }
      return true;
    }
    case ValueKind::record: return object(*type.record, in.as<capnp::DynamicStruct>(), path);
    case ValueKind::list: return list(type.element[0], in.as<capnp::DynamicList>(), path);
  }
  return true;
}

bool JsonEncoder::real(const TypePlan& type, double value, const Path&) {
  if (value == 0 && std::signbit(value)) {
    out += "-0.0";  // "-0" would be read as the whole number 0
  } else if (type.kind == ValueKind::real32) {
    fmt::format_to(std::back_inserter(out), "{}", float(value));
  } else {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
  return true;
}

bool JsonEncoder::fail(const Path& path, std::string message) {
  error = Error{{}, {}, path.text(), std::move(message), {}};
  return false;
}

}  // namespace obby::io
