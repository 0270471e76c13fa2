// What a part does to a player, field by field of its record: each behaviour is a file here and a
// row of kBehaviours.
#pragma once

#include "base/result.h"
#include "level/clocks.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// A part in work, and what becomes of it.
struct PartContext {
  schema::Part::Reader part;
  const Params& params;
  Pose pose;
  uint32_t collider;  // the number that its first collider will have
  ClockTables& clocks;
  Roles roles;
  uint32_t flags = 0;  // ColliderFlag bits
  Clock own;           // started by a touch where some behaviour has called startOwn()
};

// A touch of the part starts `clock`.
void start(PartContext& context, uint32_t clock);

// A touch of the part starts a clock of its own, which only one behaviour can set; `field` is that
// behaviour's.
Status startOwn(PartContext& context, uint32_t length, const char* field);

// Roles that do nothing.
Roles noRoles();

struct Behaviour {
  bool (*has)(schema::Part::Reader part);
  Status (*compile)(PartContext& context);  // errors have the path from the part on
  bool byTouch;                             // nothing where the part takes no touches
};

// Sets roles, flags and own clock from all behaviours of the part.
Status compileBehaviours(PartContext& context);

Status compileBoost(PartContext&);
Status compileButton(PartContext&);
Status compileConveyor(PartContext&);
Status compileFall(PartContext&);
Status compileJumpPad(PartContext&);
Status compileKill(PartContext&);
Status compileOneWay(PartContext&);
Status compileSeat(PartContext&);
Status compileSqueeze(PartContext&);
Status compileTeleport(PartContext&);
Status compileTrip(PartContext&);
Status compileVanish(PartContext&);

}  // namespace obby::level
