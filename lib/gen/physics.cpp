#include "gen/physics.h"

#include <capnp/dynamic.h>
#include <capnp/message.h>

#include "base/spelling.h"
#include "level/level.h"
#include "level/record_values.h"

namespace obby::gen {

Status setPhysics(schema::PhysicsParams::Builder to, const std::vector<NamedNumber>& changes) {
  const capnp::DynamicStruct::Builder fields(to);
  for (const NamedNumber& change : changes) {
    capnp::StructSchema::Field known;
    std::vector<std::string> names;
    bool found = false;
    for (const auto field : fields.getSchema().getFields()) {
      names.emplace_back(field.getProto().getName().cStr());
      if (names.back() != change.name) continue;
      known = field;
      found = true;
    }
    if (!found) {
      const std::string near = nearestName(change.name, names);
      return level::pathError(
          "physics." + change.name, "unknown physics parameter",
          near.empty() ? "see PhysicsParams in obby-gen --schema" : "did you mean " + near + "?");
    }
    const bool whole = known.getType().isUInt16();
    if (whole && !(change.value >= 0 && change.value <= 65535 &&
                   change.value == float(uint16_t(change.value)))) {
      return level::pathError("physics." + change.name, "expected a whole number from 0 to 65535");
    }
    capnp::DynamicStruct::Builder(to).set(known, double(change.value));
  }
  return {};
}

Result<Params> paramsOf(const std::vector<NamedNumber>& changes) {
  capnp::MallocMessageBuilder message;
  auto record = message.initRoot<schema::PhysicsParams>();
  OBBY_RETURN_IF_ERROR(setPhysics(record, changes));
  return level::compileParams(record.asReader());
}

}  // namespace obby::gen
