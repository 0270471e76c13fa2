// Makes the part solid from one side only.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileOneWay(PartContext& c) {
  OBBY_ASSIGN(c.roles.oneWay, direction(c.part.getOneWay().getDirection(), "oneWay.direction",
                                        "use [0,1,0] to make the top solid"));
  c.flags |= kOneWay;
  return {};
}

}  // namespace obby::level
