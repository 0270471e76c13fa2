#include "io/example.h"

#include <capnp/message.h>

#include "io/json_encode.h"

namespace obby::io {
namespace {

std::string defaultOf(const StructPlan& plan, const FieldPlan& field) {
  capnp::MallocMessageBuilder empty;
  const auto defaults = empty.initRoot<capnp::DynamicStruct>(plan.schema).asReader();
  JsonEncoder encoder;
  encoder.value(field.type, defaults.get(field.field), Path{});
  return encoder.out.finish();
}

std::string valueOf(const StructPlan& plan, const FieldPlan& field) {
  if (!field.example.empty()) return field.example;
  const TypePlan& type = field.type;
  if (type.kind == ValueKind::record && !type.record->tuple) return exampleOf(*type.record);
  if (type.kind == ValueKind::list && type.element[0].record != nullptr &&
      !type.element[0].record->tuple)
    return "[" + exampleOf(*type.element[0].record) + "]";
  if (type.kind == ValueKind::text) return "\"...\"";
  return defaultOf(plan, field);
}

}  // namespace

std::string exampleOf(const StructPlan& plan) {
  JsonWriter json;
  json.open('{');
  const auto add = [&](const FieldPlan& field) { json.key(field.name).raw(valueOf(plan, field)); };
  bool any = false;
  for (const FieldPlan& field : plan.fields) {
    if (field.example.empty()) continue;
    add(field);
    any = true;
  }
  if (!any && !plan.fields.empty()) add(plan.fields.front());
  return json.finish();
}

}  // namespace obby::io
