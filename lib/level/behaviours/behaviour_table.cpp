#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

using Part = schema::Part::Reader;

const Behaviour kBehaviours[] = {
    {[](Part p) { return p.hasConveyor(); }, compileConveyor, false},
    {[](Part p) { return p.hasVanish(); }, compileVanish, false},
    {[](Part p) { return p.hasOneWay(); }, compileOneWay, false},
    {[](Part p) { return p.getSqueeze() != schema::Squeeze::PUSH; }, compileSqueeze, false},
    {[](Part p) { return p.hasKill(); }, compileKill, true},
    {[](Part p) { return p.hasJumpPad(); }, compileJumpPad, true},
    {[](Part p) { return p.hasFall(); }, compileFall, false},
    {[](Part p) { return p.hasButton(); }, compileButton, true},
    {[](Part p) { return p.hasTeleport(); }, compileTeleport, true},
    {[](Part p) { return p.hasBoost(); }, compileBoost, true},
    {[](Part p) { return p.hasTrip(); }, compileTrip, true},
    {[](Part p) { return p.hasSeat(); }, compileSeat, true},
};

}  // namespace

Roles noRoles() {
  Roles r{};
  r.awayClock = r.healClock = r.seatClock = kNone;
  for (uint32_t& clock : r.starts) clock = kNone;
  return r;
}

void start(PartContext& context, uint32_t clock) {
  for (uint32_t& slot : context.roles.starts) {
    if (slot != kNone) continue;
    slot = clock;
    context.flags |= kStarts;
    return;
  }
}

Status startOwn(PartContext& context, uint32_t length, const char* field) {
  if (context.own.length != 0) {
    return pathError(field, "touching this part already starts another timed effect",
                     "make the part a button, and let this effect respond to its signal");
  }
  context.own.length = length;
  if (length != 0) start(context, kOwnClock);
  return {};
}

Status compileBehaviours(PartContext& context) {
  context.flags = context.part.getSolid() ? uint32_t(kSolid) : 0;
  context.roles = noRoles();
  for (const Behaviour& b : kBehaviours) {
    if (!b.has(context.part) || (b.byTouch && !context.part.getTouch())) continue;
    OBBY_RETURN_IF_ERROR(b.compile(context));
  }
  if (context.part.getByRoot() && context.part.getTouch()) context.flags |= kByRoot;
  return {};
}

}  // namespace obby::level
