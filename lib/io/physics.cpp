#include "io/physics.h"

#include <capnp/dynamic.h>

namespace obby::io {

void applyParams(schema::PhysicsParams::Reader params, schema::Level::Builder level) {
  capnp::DynamicStruct::Builder physics(level.getPhysics());
  const capnp::DynamicStruct::Reader found(params);
  RecordBuilder fresh;
  const capnp::DynamicStruct::Reader usual(fresh.root().initParams().asReader());
  for (const auto field : found.getSchema().getFields()) {
    if (physics.asReader().get(field).as<double>() == usual.get(field).as<double>())
      physics.set(field, found.get(field));
  }
}

Record Physics::applied(const Record& level) const {
  RecordBuilder copy(level.reader());
  apply(copy.root().getLevel());
  return Record(std::move(copy));
}

void Physics::apply(schema::Level::Builder level) const {
  if (params_) applyParams(params_->reader().getParams(), level);
}

}  // namespace obby::io
