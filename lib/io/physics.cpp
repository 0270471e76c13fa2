#include "io/physics.h"

#include <capnp/dynamic.h>

namespace obby::io {

Record Physics::applied(const Record& level) const {
  if (!params_) return level;
  RecordBuilder copy(level.reader());
  capnp::DynamicStruct::Builder physics(copy.root().getLevel().getPhysics());
  const capnp::DynamicStruct::Reader found(params_->reader().getParams());
  RecordBuilder fresh;
  const capnp::DynamicStruct::Reader usual(fresh.root().initParams().asReader());
  for (const auto field : found.getSchema().getFields()) {
    if (physics.asReader().get(field).as<double>() == usual.get(field).as<double>())
      physics.set(field, found.get(field));
  }
  return Record(std::move(copy));
}

}  // namespace obby::io
