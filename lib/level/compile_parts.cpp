#include "level/compile_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <unordered_map>

#include "base/hash.h"
#include "level/behaviours/behaviour.h"
#include "level/behaviours/fall.h"
#include "level/compile_loose.h"
#include "level/record_values.h"
#include "level/upright.h"

namespace obby::level {
namespace {

using geom::ShapeKind;

// What a part does that takes more than its flag to know.
constexpr uint32_t kWithRole =
    kTouchRoles | kConveyor | kVanishTimer | kClocked | kOneWay | kTriggered;

// Which way round they are matters: their axes are not exchanged to stand upright.
constexpr uint32_t kKeepsAxes = kOneWay | kSeat;

class PartCompiler {
 public:
  PartCompiler(PartTables& out, const Params& params) : out_(out), params_(params) {}

  Status addSignals(schema::Level::Reader level) { return clocks_.addSignals(level, params_); }
  // `index` of the part in the record.
  Status add(schema::Part::Reader part, uint32_t index);
  Status finish();

 private:
  Result<MotionTables> tables(const PartContext& c) const;
  Result<uint32_t> trigger(PartContext& c, const MotionTables& tables);
  Status mover(PartContext& c, Collider& collider);
  Status shapes(schema::Part::Reader part, Collider collider, uint32_t flags);
  Status hulls(schema::Part::Reader part, const Collider& base, uint32_t flags);
  void push(Collider collider, uint32_t flags);
  Box sweptBounds(const Collider& collider) const;

  const std::vector<Mat3>& sharedSpins(MotionTables& tables);

  PartTables& out_;
  const Params& params_;
  ClockTables clocks_;
  std::vector<Clock> own_;                                             // (roles)
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

// Nobody meets it.
bool isScenery(const PartContext& c) { return (c.flags & (kSolid | kTouchRoles)) == 0; }

Result<MotionTables> PartCompiler::tables(const PartContext& c) const {
  if (c.part.hasMotion()) return motionTables(c.part.getMotion(), c.pose, params_);
  return fallTables(c.part.getFall(), c.pose, params_);
}

// The clock that moves a part; kNone: the level's.
Result<uint32_t> PartCompiler::trigger(PartContext& c, const MotionTables& tables) {
  if (c.part.hasFall()) return kOwnClock;
  const auto motion = c.part.getMotion();
  const bool signal = motion.getTrigger() == schema::MotionTrigger::SIGNAL;
  if (signal) return clocks_.signal(motion.getSignal(), "motion.signal");
  if (motion.getSignal().size() != 0) {
    return pathError("motion.signal", "does nothing with this trigger",
                     "set \"trigger\":\"signal\"");
  }
  OBBY_ASSIGN(const uint32_t asked, ticksOf(params_, motion.getSeconds(), "motion.seconds"));
  if (motion.getTrigger() == schema::MotionTrigger::ALWAYS) return kNone;
  uint32_t length = asked != 0 ? asked : tables.once ? kForever : tables.period;
  // A part that nothing can touch rests for good: its clock never starts.
  if (c.part.getTouch()) OBBY_RETURN_IF_ERROR(startOwn(c, length, "motion.trigger"));
  return kOwnClock;
}

Status PartCompiler::mover(PartContext& c, Collider& collider) {
  OBBY_ASSIGN(MotionTables tables, this->tables(c));
  OBBY_ASSIGN(const uint32_t trigger, this->trigger(c, tables));
  if (isScenery(c)) return {};
  if (tables.keys.size() == 1 && tables.spins.empty()) {
    collider.pose = tables.keys[0];
    return {};
  }
  out_.motions.push_back(std::move(tables));
  MotionTables& kept = out_.motions.back();
  // push() drops it for shapes that are no blocks.
  if (!(c.flags & kKeepsAxes) && makeUpright(kept)) c.flags |= kUpright;
  const std::vector<Mat3>& spins = sharedSpins(kept);
  rows_ += kept.keys.size() + kept.spins.size();
  if (rows_ > kMaxLevelRows) {
    return pathError(
        c.part.hasMotion() ? "motion" : "fall",
        fmt::format("all motions together need more than {} ticks of tables", kMaxLevelRows),
        "parts that spin alike share a table, and a period of whole ticks needs the shortest");
  }
  collider.mover = uint32_t(out_.movers.size());
  out_.movers.push_back({kept.keys.data(), spins.empty() ? nullptr : spins.data(),
                         uint32_t(kept.keys.size()), uint32_t(spins.size()), kept.pivot, kept.once,
                         trigger});
  c.flags |= kMoving;
  if (!c.part.hasMotion() || c.part.getMotion().getCarries()) c.flags |= kCarries;
  if (trigger == kNone) {
    out_.timed = true;
  } else {
    c.flags |= kTriggered;
  }
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

void PartCompiler::push(Collider collider, uint32_t flags) {
  if (collider.kind != ShapeKind::block) {
    flags &= ~uint32_t(kUpright);  // the short cuts are for blocks only
  } else {
    flags |= kBlock;
    const bool still = collider.mover == kNone && collider.loose == kNotLoose;
    if (still && !(flags & kKeepsAxes) && makeUpright(collider)) flags |= kUpright;
  }
  out_.bounds.push_back(makeBounds(sweptBounds(collider), flags, uint32_t(out_.bounds.size()),
                                   collider.friction < params_.iceFriction));
  out_.colliders.push_back(collider);
}

Status PartCompiler::hulls(schema::Part::Reader part, const Collider& base, uint32_t flags) {
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
    const geom::Hull* const hull = out_.hulls.hullOf(vertices);
    if (hull == nullptr) continue;  // flat: nothing to collide with
    Collider c = base;
    c.shape.hull = hull;
    Vec3 reach;
    for (uint32_t i = 0; i < hull->vertexCount; ++i) reach = max(reach, abs(hull->vertices[i]));
    c.shape.half = reach;
    push(c, flags);
  }
  return {};
}

Status PartCompiler::shapes(schema::Part::Reader part, Collider collider, uint32_t flags) {
  collider.kind = ShapeKind(uint8_t(part.getShape()));
  if (collider.kind == ShapeKind::truss) {
    collider.kind = ShapeKind::block;
    flags |= kTruss;
  }
  if (part.getClimbable()) flags |= kTruss | kRung;
  if (collider.kind == ShapeKind::hull && part.getHulls().size() != 0)
    return hulls(part, collider, flags);
  if (collider.kind == ShapeKind::hull)
    collider.kind = ShapeKind::block;  // its hulls are not known: the box
  push(collider, flags);
  return {};
}

Status PartCompiler::add(schema::Part::Reader part, uint32_t index) {
  if (uint16_t(part.getShape()) > uint16_t(schema::Shape::HULL))
    return pathError("shape", "unknown shape");
  if (!(part.getFriction() >= 0 && part.getFriction() <= kMaxFriction))
    return pathError("friction", fmt::format("expected a number from 0 to {}", kMaxFriction));
  if (!(part.getElasticity() >= 0 && part.getElasticity() <= 1))
    return pathError("elasticity", "expected a number from 0 to 1");
  OBBY_ASSIGN(const Vec3 half, halfExtents(part));
  OBBY_ASSIGN(const Vec3 center, position(part.getPosition(), "position"));
  OBBY_ASSIGN(const Mat3 axes, rotation(part.getRotation(), "rotation"));
  const Pose pose{center, axes};
  PartContext c{part, params_, pose, uint32_t(out_.colliders.size()), clocks_, {}, 0, {}};
  OBBY_RETURN_IF_ERROR(compileBehaviours(c));
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
    c.flags |= kLoose;
  }
  const bool falls = part.hasFall() && part.getTouch();
  if (part.hasMotion() || falls) OBBY_RETURN_IF_ERROR(mover(c, collider));
  if (isScenery(c)) return {};
  if (c.flags & kVanishTimer) out_.timed = true;
  if (c.flags & kWithRole) {
    collider.role = uint32_t(out_.roles.size());
    out_.roles.push_back(c.roles);
    own_.push_back(c.own);
  }
  const size_t first = out_.colliders.size();
  OBBY_RETURN_IF_ERROR(shapes(part, collider, c.flags));
  if (c.flags & kLoose) {
    if (first == out_.colliders.size()) return {};  // flat hulls only
    OBBY_ASSIGN(const Loose loose, looseFrom(part, center, out_.colliders, first));
    out_.loose.push_back(loose);
    return {};
  }
  out_.fixedColliders = out_.colliders.size();
  return {};
}

Status PartCompiler::finish() {
  OBBY_RETURN_IF_ERROR(clocks_.checkSignals());
  bool crushes = false;
  for (const Bounds& b : out_.bounds) crushes = crushes || (b.flags & kCrush) != 0;
  if (crushes) clocks_.add({kForever});
  out_.clocks = clocks_.finish(own_, out_.colliders, out_.roles, out_.movers);
  if (crushes) out_.crushClock = uint32_t(out_.clocks.size() - 1);
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
  OBBY_RETURN_IF_ERROR(compiler.addSignals(record));
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
  OBBY_RETURN_IF_ERROR(compiler.finish());
  const Vec3 nowhere{1e38f, 1e38f, 1e38f};
  out.bounds.push_back(makeBounds({nowhere, -nowhere}, 0, uint32_t(out.bounds.size()), false));
  return out;
}

}  // namespace obby::level
