// Behaviours of parts, which are the effects of a part's fields on a player. Each behaviour is a
// file here and a row of kBehaviours.
#pragma once

#include "base/result.h"
#include "level/clocks.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// A part that is being compiled, with its results so far.
struct PartContext {
  schema::Part::Reader part;
  const Params& params;
  Pose pose;
  uint32_t collider;  // index that the part's first collider will have
  ClockTables& clocks;
  Roles roles;
  uint32_t flags = 0;  // ColliderFlag bits
  Clock own;           // clock that a touch starts, if a behaviour has called startOwn()
};

// Makes a touch of the part start `clock`.
void start(PartContext& context, uint32_t clock);

// Makes a touch of the part start the part's own clock. A second behaviour that sets this clock is
// an error at `field`.
Status startOwn(PartContext& context, uint32_t length, const char* field);

// Returns roles that do nothing.
Roles noRoles();

struct Behaviour {
  bool (*has)(schema::Part::Reader part);
  Status (*compile)(PartContext& context);  // errors have the path relative to the part
  bool byTouch;                             // acts only by touch
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
