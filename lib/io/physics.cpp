#include "io/physics.h"

#include <capnp/dynamic.h>

namespace obby::io {

Record Physics::applied(const Record& level) const {
  RecordBuilder copy(level.reader());
  apply(copy.root().getLevel());
  return Record(std::move(copy));
}

void Physics::apply(schema::Level::Builder level) const {
  if (!params_) return;
  capnp::DynamicStruct::Builder physics(level.getPhysics());
  const capnp::DynamicStruct::Reader found(params_->reader().getParams());
  RecordBuilder fresh;
  const capnp::DynamicStruct::Reader usual(fresh.root().initParams().asReader());
  for (const auto field : found.getSchema().getFields()) {
    if (physics.asReader().get(field).as<double>() == usual.get(field).as<double>())
      physics.set(field, found.get(field));
  }
}

}  // namespace obby::io
