// The order in which roles win.
#include "view/roles.h"

namespace obby::view {
namespace {

Role roleOf(schema::Part::Reader part) {
  if (part.hasKill()) return Role::kill;
  if (part.hasGoal()) return Role::goal;
  if (part.hasCheckpoint()) return Role::checkpoint;
  if (part.hasVanish()) return Role::vanish;
  if (part.hasJumpPad()) return Role::pad;
  if (part.hasConveyor()) return Role::conveyor;
  if (part.hasMotion()) return Role::moving;
  if (!part.getSolid()) return Role::ghost;
  return part.getAnchored() ? Role::plain : Role::loose;
}

}  // namespace

std::vector<Role> rolesOf(schema::Level::Reader level) {
  std::vector<Role> roles;
  roles.reserve(level.getParts().size());
  for (const auto part : level.getParts()) roles.push_back(roleOf(part));
  for (const auto spawn : level.getSpawns()) {
    if (spawn.getPart() < 0 || size_t(spawn.getPart()) >= roles.size()) continue;
    Role& role = roles[size_t(spawn.getPart())];
    if (role == Role::kill || role == Role::goal) continue;
    role = spawn.getStage() == 0 ? Role::start : Role::checkpoint;
  }
  return roles;
}

}  // namespace obby::view
