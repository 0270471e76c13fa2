// The precedence of roles.
#include "view/roles.h"

#include "math/vec.h"

namespace obby::view {
namespace {

Role roleOf(schema::Part::Reader part) {
  if (part.hasKill() && part.getKill().getDamage() > 0) return Role::kill;  // negative damage heals
  if (part.hasGoal()) return Role::goal;
  if (part.hasCheckpoint()) return Role::checkpoint;
  if (part.hasVanish() || (part.hasFall() && part.getTouch())) return Role::vanish;
  if (part.hasJumpPad()) return Role::pad;
  if (part.hasConveyor()) return Role::conveyor;
  if (part.hasMotion()) return Role::moving;
  if (!part.getSolid()) return Role::ghost;
  return part.getAnchored() ? Role::plain : Role::dynamic;
}

// Returns the plain part below a spawn that has no part of its own, or -1.
int32_t partUnder(schema::Level::Reader level, const std::vector<Role>& roles, Vec3 feet) {
  constexpr float kReach = 1.5f;  // max distance from the feet down to the part's top, studs
  for (uint32_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != Role::plain) continue;
    const auto part = level.getParts()[i];
    const auto p = part.getPosition();
    const auto q = part.getRotation();
    const auto s = part.getSize();
    const Mat3 axes = toMat3(normalize(Quat{q.getX(), q.getY(), q.getZ(), q.getW()}));
    const Vec3 below = toLocal(axes, feet - Vec3{p.getX(), p.getY() + kReach / 2, p.getZ()});
    const Vec3 gap = abs(below) - Vec3{s.getX(), s.getY(), s.getZ()} * 0.5f;
    if (gap.x < 0 && gap.z < 0 && gap.y < kReach / 2) return int32_t(i);
  }
  return -1;
}

}  // namespace

std::vector<Role> rolesOf(schema::Level::Reader level) {
  std::vector<Role> roles;
  roles.reserve(level.getParts().size());
  for (const auto part : level.getParts()) roles.push_back(roleOf(part));
  for (const auto spawn : level.getSpawns()) {
    const auto at = spawn.getPosition();
    const int32_t part = spawn.getPart() >= 0
                             ? spawn.getPart()
                             : partUnder(level, roles, {at.getX(), at.getY(), at.getZ()});
    if (part < 0 || size_t(part) >= roles.size()) continue;
    Role& role = roles[size_t(part)];
    if (role == Role::kill || role == Role::goal) continue;
    role = spawn.getStage() == 0 ? Role::start : Role::checkpoint;
  }
  return roles;
}

}  // namespace obby::view
