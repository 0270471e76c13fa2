#include "level/compile_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <unordered_map>

#include "base/hash.h"
#include "level/mass.h"
#include "level/record_values.h"
#include "level/upright.h"

namespace obby::level {
namespace {

using geom::ShapeKind;

class PartCompiler {
 public:
  PartCompiler(PartTables& out, const Params& params) : out_(out), params_(params) {}

  // `index` of the part in the record.
  Status add(schema::Part::Reader part, uint32_t index);

 private:
  Result<uint16_t> roles(schema::Part::Reader part, const Pose& pose, Roles& roles) const;
  Status mover(schema::Part::Reader part, const Pose& pose, Collider& collider, uint16_t& flags);
  Status shapes(schema::Part::Reader part, Collider collider, uint16_t flags);
  Status hulls(schema::Part::Reader part, const Collider& base, uint16_t flags);
  void push(Collider collider, uint16_t flags);
  Status loosen(schema::Part::Reader part, Vec3 at, size_t firstCollider);
  Box sweptBounds(const Collider& collider) const;

  const std::vector<Mat3>& sharedSpins(MotionTables& tables);

  PartTables& out_;
  const Params& params_;
  std::unordered_multimap<uint64_t, const std::vector<Mat3>*> spins_;  // by digest
  size_t rows_ = 0;                                                    // of all tables
};

Result<Vec3> halfExtents(schema::Part::Reader part) {
  const Vec3 size = vec(part.getSize());
  if (!isFinite(size) || !(size.x > 0 && size.y > 0 && size.z > 0) ||
      maxf(size.x, maxf(size.y, size.z)) > kMaxSize) {
    return pathError("size", "expected three numbers above 0 and at most 2048");
  }
  return max(size, Vec3{kMinSize, kMinSize, kMinSize}) * 0.5f;
}

// Physics moves it: nothing holds it, and something can push it.
bool isLoose(schema::Part::Reader part) {
  return !part.getAnchored() && part.getSolid() && !part.hasMotion();
}

Status finiteFields(schema::Part::Reader part) {
  if (!(part.getElasticity() >= 0 && part.getElasticity() <= 1))
    return pathError("elasticity", "expected a number from 0 to 1");
  if (!(part.getFriction() >= 0))
    return pathError("friction", "expected a number that is not negative");
  if (part.hasKill() && !(part.getKill().getCooldown() >= 0)) {
    return pathError("kill.cooldown", "expected seconds that are not negative");
  }
  if (part.hasKill() && !std::isfinite(part.getKill().getDamage()))
    return pathError("kill.damage", "expected a number");
  return {};
}

Result<uint16_t> PartCompiler::roles(schema::Part::Reader part, const Pose& pose,
                                     Roles& roles) const {
  uint16_t flags = part.getSolid() ? kSolid : 0;
  roles.conveyorCenter = pose.position;
  if (part.hasConveyor()) {
    OBBY_ASSIGN(roles.conveyorVelocity,
                position(part.getConveyor().getVelocity(), "conveyor.velocity"));
    OBBY_ASSIGN(roles.conveyorAngular,
                position(part.getConveyor().getAngular(), "conveyor.angular"));
    flags |= kConveyor;
  }
  if (part.hasVanish()) {
    const auto vanish = part.getVanish();
    roles.vanishDelay = ticksFromSeconds(params_, vanish.getDelay());
    roles.vanishAway = ticksFromSeconds(params_, vanish.getAway());
    roles.vanishPhase = ticksFromSeconds(params_, vanish.getPhase());
    const bool timer = vanish.getTrigger() == schema::VanishTrigger::TIMER;
    if (timer && roles.vanishDelay + roles.vanishAway == 0)
      return pathError("vanish", "a period of 0 ticks");
    if (timer) flags |= kVanishTimer;
    if (!timer && part.getTouch()) flags |= kVanishTouch;
  }
  if (!part.getTouch()) return flags;
  if (part.hasKill()) {
    roles.damage = part.getKill().getDamage();
    roles.cooldownTicks =
        uint16_t(std::min(ticksFromSeconds(params_, part.getKill().getCooldown()), 65535u));
    flags |= kKill;
  }
  if (part.hasJumpPad()) {
    OBBY_ASSIGN(roles.padVelocity, position(part.getJumpPad().getVelocity(), "jumpPad.velocity"));
    roles.padKeepsSideways = part.getJumpPad().getKeepSideways();
    flags |= kPad;
  }
  return flags;
}

Status PartCompiler::mover(schema::Part::Reader part, const Pose& pose, Collider& collider,
                           uint16_t& flags) {
  OBBY_ASSIGN(MotionTables tables, motionTables(part.getMotion(), pose, params_));
  if (tables.keys.size() == 1 && tables.spins.empty()) {
    collider.pose = tables.keys[0];
    return {};
  }
  out_.motions.push_back(std::move(tables));
  MotionTables& kept = out_.motions.back();
  if (makeUpright(kept)) flags |= kUpright;  // push() drops it for shapes that are no blocks
  const std::vector<Mat3>& spins = sharedSpins(kept);
  rows_ += kept.keys.size() + kept.spins.size();
  if (rows_ > kMaxLevelRows) {
    return pathError("motion", fmt::format("all motions together need more than {} ticks of tables",
                                           kMaxLevelRows));
  }
  collider.mover = uint32_t(out_.movers.size());
  out_.movers.push_back({kept.keys.data(), spins.empty() ? nullptr : spins.data(),
                         uint32_t(kept.keys.size()), uint32_t(spins.size()), kept.pivot,
                         kept.once});
  flags |= kMoving;
  if (part.getMotion().getCarries()) flags |= kCarries;
  out_.timed = true;
  return {};
}

// The table of an earlier part that spins alike, or this part's own: whole courses spin at one
// rate.
const std::vector<Mat3>& PartCompiler::sharedSpins(MotionTables& tables) {
  if (tables.spins.empty()) return tables.spins;
  const size_t bytes = tables.spins.size() * sizeof(Mat3);
  const auto [first, last] = spins_.equal_range(hashBytes(tables.spins.data(), bytes));
  for (auto it = first; it != last; ++it) {
    const std::vector<Mat3>& known = *it->second;
    if (known.size() != tables.spins.size() ||
        std::memcmp(known.data(), tables.spins.data(), bytes) != 0)
      continue;
    tables.spins = {};
    return known;
  }
  spins_.emplace(hashBytes(tables.spins.data(), bytes), &tables.spins);
  return tables.spins;
}

// Bounds over all rows of both tables: each key's centre with the largest radius about the pivot
// where it spins.
Box PartCompiler::sweptBounds(const Collider& c) const {
  if (c.mover == kNone) return boundsOf(c.pose, c.shape.half);
  const Mover& m = out_.movers[c.mover];
  Box swept{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
  const float radius = length(c.shape.half) + length(m.pivot);
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Pose& key = m.keys[k];
    const Vec3 pivot = toWorld(key, m.pivot);
    const Vec3 r{radius, radius, radius};
    swept = join(swept, m.spinCount == 0 ? boundsOf(key, c.shape.half) : Box{pivot - r, pivot + r});
  }
  return swept;
}

void PartCompiler::push(Collider collider, uint16_t flags) {
  if (collider.kind != ShapeKind::block) {
    flags &= uint16_t(~kUpright);  // the short cuts are for blocks only
  } else {
    flags |= kBlock;
    const bool still = collider.mover == kNone && collider.loose == kNotLoose;
    if (still && makeUpright(collider)) flags |= kUpright;
  }
  out_.bounds.push_back(makeBounds(sweptBounds(collider), flags, uint32_t(out_.bounds.size()),
                                   collider.friction < params_.iceFriction));
  out_.colliders.push_back(collider);
}

Status PartCompiler::hulls(schema::Part::Reader part, const Collider& base, uint16_t flags) {
  size_t index = 0;
  for (const auto record : part.getHulls()) {
    const std::string path = fmt::format("hulls[{}].vertices", index++);
    std::vector<Vec3> vertices;
    for (const auto v : record.getVertices()) {
      OBBY_ASSIGN(const Vec3 at, position(v, path));
      vertices.push_back(at);
    }
    if (vertices.size() < 4 || vertices.size() > kMaxHullVertices) {
      return pathError(path, fmt::format("expected 4 to {} vertices, got {}", kMaxHullVertices,
                                         vertices.size()));
    }
    out_.hulls.push_back(hullTables(vertices));
    const HullTables& t = out_.hulls.back();
    if (t.normals.empty()) continue;  // flat: nothing to collide with
    out_.hullViews.push_back(viewOf(t));
    Collider c = base;
    c.shape.hull = &out_.hullViews.back();
    Vec3 reach;
    for (const Vec3 v : t.vertices) reach = max(reach, abs(v));
    c.shape.half = reach;
    push(c, flags);
  }
  return {};
}

Status PartCompiler::shapes(schema::Part::Reader part, Collider collider, uint16_t flags) {
  collider.kind = ShapeKind(uint8_t(part.getShape()));
  if (collider.kind == ShapeKind::truss) {
    collider.kind = ShapeKind::block;
    flags |= kTruss;
  }
  if (collider.kind == ShapeKind::hull && part.getHulls().size() != 0)
    return hulls(part, collider, flags);
  if (collider.kind == ShapeKind::hull)
    collider.kind = ShapeKind::block;  // its hulls are not known: the box
  push(collider, flags);
  return {};
}

// Makes a body of the colliders from `firstCollider` on.
Status PartCompiler::loosen(schema::Part::Reader part, Vec3 at, size_t firstCollider) {
  if (firstCollider == out_.colliders.size()) return {};  // flat hulls only
  if (!(part.getDensity() >= 1e-4f && part.getDensity() <= 100))
    return pathError("density", "expected a number from 0.0001 to 100");
  std::vector<SolidShape> shapes;
  float radius = 0;
  for (size_t i = firstCollider; i < out_.colliders.size(); ++i) {
    shapes.push_back({out_.colliders[i].kind, out_.colliders[i].shape});
    radius = maxf(radius, length(out_.colliders[i].shape.half));
  }
  const MassProperties mass = massOf(shapes, part.getDensity());
  if (!(mass.mass > 0)) return pathError("size", "a loose part needs a volume");
  OBBY_ASSIGN(const Quat turned, quaternion(part.getRotation(), "rotation"));
  Loose loose{at, turned, mass.center, mass.inverseInertia, 1 / mass.mass, 0, 0, 0};
  loose.radius = radius + length(mass.center);
  loose.firstCollider = uint32_t(firstCollider);
  loose.colliderCount = uint32_t(shapes.size());
  out_.loose.push_back(loose);
  return {};
}

Status PartCompiler::add(schema::Part::Reader part, uint32_t index) {
  if (uint16_t(part.getShape()) > uint16_t(schema::Shape::HULL))
    return pathError("shape", "unknown shape");
  OBBY_RETURN_IF_ERROR(finiteFields(part));
  OBBY_ASSIGN(const Vec3 half, halfExtents(part));
  OBBY_ASSIGN(const Vec3 center, position(part.getPosition(), "position"));
  OBBY_ASSIGN(const Mat3 axes, rotation(part.getRotation(), "rotation"));
  const Pose pose{center, axes};
  Roles roleTable{};
  OBBY_ASSIGN(uint16_t flags, roles(part, pose, roleTable));
  if (flags & kVanishTimer) out_.timed = true;
  Collider collider{pose,
                    {half, nullptr},
                    index,
                    kNone,
                    kNone,
                    part.getFriction(),
                    part.getElasticity(),
                    ShapeKind::block,
                    kNotLoose};
  if (isLoose(part)) {
    collider.loose = uint8_t(out_.loose.size());
    flags |= kLoose;
  }
  if (part.hasMotion()) OBBY_RETURN_IF_ERROR(mover(part, pose, collider, flags));
  if ((flags & (kSolid | kTouchRoles)) == 0) return {};  // scenery
  if (flags & (kTouchRoles | kConveyor | kVanishTimer)) {
    collider.role = uint32_t(out_.roles.size());
    out_.roles.push_back(roleTable);
  }
  const size_t first = out_.colliders.size();
  OBBY_RETURN_IF_ERROR(shapes(part, collider, flags));
  if (flags & kLoose) return loosen(part, center, first);
  out_.fixedColliders = out_.colliders.size();
  return {};
}

}  // namespace

Result<PartTables> compileParts(schema::Level::Reader record, const Params& params) {
  PartTables out;
  if (record.getParts().size() > kMaxParts) {
    return pathError("parts", fmt::format("expected at most {} parts, got {}", kMaxParts,
                                          record.getParts().size()));
  }
  PartCompiler compiler(out, params);
  std::vector<uint32_t> loose;
  const auto add = [&](uint32_t index) -> Status {
    auto status = compiler.add(record.getParts()[index], index);
    if (status) return {};
    Error error = std::move(status).error();
    error.path = fmt::format("parts[{}]{}{}", index, error.path.empty() ? "" : ".", error.path);
    return error;
  };
  for (uint32_t index = 0; index < record.getParts().size(); ++index) {
    const auto part = record.getParts()[index];
    out.names.push_back(part.getName());
    if (isLoose(part)) {
      loose.push_back(index);
    } else {
      OBBY_RETURN_IF_ERROR(add(index));
    }
  }
  if (loose.size() > kMaxLoose) {
    return pathError(fmt::format("parts[{}].anchored", loose[kMaxLoose]),
                     fmt::format("expected at most {} loose parts, got {}: anchor those that "
                                 "nobody pushes",
                                 kMaxLoose, loose.size()));
  }
  for (const uint32_t index : loose) OBBY_RETURN_IF_ERROR(add(index));
  const Vec3 nowhere{1e38f, 1e38f, 1e38f};
  out.bounds.push_back(makeBounds({nowhere, -nowhere}, 0, uint32_t(out.bounds.size()), false));
  return out;
}

}  // namespace obby::level
