#include "level/compile_parts.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "level/behaviours/behaviour.h"
#include "level/behaviours/fall.h"
#include "level/compile_bodies.h"
#include "level/compile_hulls.h"
#include "level/part_numbers.h"
#include "level/record_values.h"
#include "level/swept_bounds.h"
#include "level/upright.h"

namespace obby::level {
namespace {

using geom::ShapeKind;

// Flags of parts that need a row of Roles.
constexpr uint32_t kWithRole =
    kTouchRoles | kConveyor | kVanishTimer | kClocked | kOneWay | kTriggered;

// The orientation of these parts matters, so their axes are not exchanged to make them upright.
constexpr uint32_t kKeepsAxes = kOneWay | kSeat;

class PartCompiler {
 public:
  // A table has at most `maxRows` rows, or as many as one repetition needs.
  PartCompiler(PartTables& out, const Params& params, uint32_t maxRows)
      : out_(out), params_(params), maxRows_(maxRows) {}

  Status compile(schema::Level::Reader level);

  // Returns true if the error means that all tables together have too many rows.
  bool isOverBudget() const { return overBudget_; }

 private:
  // `index` is the part's index in the record. An error has the whole path.
  Status addAt(schema::Part::Reader part, uint32_t index);
  Status add(schema::Part::Reader part, uint32_t index);
  Status finish();
  Result<uint32_t> trigger(PartContext& c, const MotionPlan& plan);
  Status mover(PartContext& c, Collider& collider);
  Status checkBudget(const PartContext& c);
  Status shapes(schema::Part::Reader part, Collider collider, uint32_t flags);
  Status hulls(schema::Part::Reader part, const Collider& base, uint32_t flags);
  void push(Collider collider, uint32_t flags);

  PartTables& out_;
  const Params& params_;
  const uint32_t maxRows_;
  ClockTables clocks_;
  std::vector<Clock> own_;  // (roles)
  SweptBounds swept_;       // bounds of the last mover
  size_t keyRows_ = 0;      // rows of all tables of keys together
  bool overBudget_ = false;
};

// Returns true if the part cannot affect a player. A part with doubts may affect a player in the
// game, so it is kept and answers name it.
bool isScenery(const PartContext& c) {
  return (c.flags & (kSolid | kTouchRoles)) == 0 && c.part.getDoubts().size() == 0;
}

// Returns the clock that moves a part, or kNone for the level's clock.
Result<uint32_t> PartCompiler::trigger(PartContext& c, const MotionPlan& plan) {
  if (c.part.hasFall()) return kOwnClock;
  const auto motion = c.part.getMotion();
  const bool signal = motion.getTrigger() == schema::MotionTrigger::SIGNAL;
  if (signal) return clocks_.signal(motion.getSignal(), "motion.signal");
  if (motion.getSignal().size() != 0) {
    return pathError("motion.signal", "a signal has no effect with this trigger",
                     "set \"trigger\":\"signal\", or remove the signal");
  }
  OBBY_ASSIGN(const uint32_t asked, ticksOf(params_, motion.getSeconds(), "motion.seconds"));
  if (motion.getTrigger() == schema::MotionTrigger::ALWAYS) return kNone;
  const uint32_t length = asked != 0 ? asked : plan.once ? kForever : plan.period;
  // A part that cannot be touched stays at rest: its clock never starts.
  if (c.part.getTouch()) OBBY_RETURN_IF_ERROR(startOwn(c, length, "motion.trigger"));
  return kOwnClock;
}

Status PartCompiler::mover(PartContext& c, Collider& collider) {
  MotionPlan plan;
  plan.once = c.part.hasFall();
  if (c.part.hasMotion()) {
    OBBY_ASSIGN(plan, planMotion(c.part.getMotion(), params_, maxRows_));
  }
  OBBY_ASSIGN(const uint32_t trigger, this->trigger(c, plan));
  if (isScenery(c)) return {};
  std::vector<Pose> table =
      c.part.hasMotion() ? keyTable(plan, c.pose) : fallTable(c.part.getFall(), c.pose, params_);
  if (table.size() == 1 && plan.spin.rows == 0) {
    collider.pose = table[0];
    return {};
  }
  out_.motions.push_back(std::move(table));
  std::vector<Pose>& keys = out_.motions.back();
  const bool keysStand = !(c.flags & kKeepsAxes) && isUpright(keys);
  const SpinTurns turns = out_.spins.of(plan.spin, keysStand);
  if (turns.upright) {
    snapUpright(keys);
    c.flags |= kUpright;  // push() clears the flag for shapes that are not blocks
  }
  keyRows_ += keys.size();
  OBBY_RETURN_IF_ERROR(checkBudget(c));
  collider.mover = uint32_t(out_.movers.size());
  out_.movers.push_back({keys.data(), turns.rows.data(), uint32_t(keys.size()),
                         uint32_t(turns.rows.size()), plan.pivot, plan.once, trigger});
  const bool ofHulls = c.part.getShape() == schema::Shape::HULL;
  swept_ = SweptBounds(out_.movers.back(), ofHulls ? c.part.getHulls().size() : 1u);
  c.flags |= kMoving;
  if (!c.part.hasMotion() || c.part.getMotion().getCarries()) c.flags |= kCarries;
  if (trigger == kNone) {
    out_.timed = true;
  } else {
    c.flags |= kTriggered;
  }
  return {};
}

Status PartCompiler::checkBudget(const PartContext& c) {
  if (keyRows_ + out_.spins.rows() <= kMaxLevelRows) return {};
  overBudget_ = true;
  return pathError(
      c.part.hasMotion() ? "motion" : "fall",
      fmt::format("the level's motions together need more than {} stored poses", kMaxLevelRows),
      "shorten some motions, or give several parts the same spin, which then counts only once");
}

void PartCompiler::push(Collider collider, uint32_t flags) {
  if (collider.kind != ShapeKind::block) {
    flags &= ~uint32_t(kUpright);  // only blocks have the short cuts
  } else {
    flags |= kBlock;
    const bool still = collider.mover == kNone && collider.body == kNoBody;
    if (still && !(flags & kKeepsAxes) && makeUpright(collider)) flags |= kUpright;
  }
  const Vec3 half = collider.shape.half;
  const Box box = collider.mover == kNone ? boundsOf(collider.pose, half) : swept_.of(half);
  out_.bounds.push_back(
      makeBounds(box, flags, uint32_t(out_.bounds.size()), collider.grip != params_.plainGrip));
  out_.colliders.push_back(collider);
}

Status PartCompiler::hulls(schema::Part::Reader part, const Collider& base, uint32_t flags) {
  OBBY_ASSIGN(const std::vector<const geom::Hull*> hulls, hullsOf(part, out_.hulls));
  for (const geom::Hull* const hull : hulls) {
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
    collider.kind = ShapeKind::block;  // a part without hulls uses its box
  push(collider, flags);
  return {};
}

Status PartCompiler::add(schema::Part::Reader part, uint32_t index) {
  if (uint16_t(part.getShape()) > uint16_t(schema::Shape::HULL))
    return pathError("shape", "unknown shape");
  OBBY_RETURN_IF_ERROR(checkSurface(part));
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
                    pairFriction(params_, part.getFriction(), part.getFrictionWeight()),
                    part.getElasticity(),
                    ShapeKind::block,
                    kNoBody};
  if (isDynamic(part)) {
    collider.body = uint8_t(out_.bodies.size());
    c.flags |= kDynamic;
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
  if (c.flags & kDynamic) {
    if (first == out_.colliders.size()) return {};  // flat hulls only
    OBBY_ASSIGN(const DynamicBody body, bodyFrom(part, center, out_.colliders, first));
    out_.bodies.push_back(body);
    return {};
  }
  out_.fixedColliders = out_.colliders.size();
  return {};
}

Status PartCompiler::addAt(schema::Part::Reader part, uint32_t index) {
  auto status = add(part, index);
  if (status) return {};
  Error error = std::move(status).error();
  error.path = fmt::format("parts[{}]{}{}", index, error.path.empty() ? "" : ".", error.path);
  return error;
}

Status PartCompiler::compile(schema::Level::Reader level) {
  OBBY_RETURN_IF_ERROR(clocks_.addSignals(level, params_));
  std::vector<uint32_t> bodies;
  const auto parts = level.getParts();
  for (uint32_t index = 0; index < parts.size(); ++index) {
    const auto part = parts[index];
    out_.names.push_back(part.getName());
    if (isDynamic(part)) {
      bodies.push_back(index);
    } else {
      OBBY_RETURN_IF_ERROR(addAt(part, index));
    }
  }
  if (bodies.size() > kMaxBodies) {
    return pathError(
        fmt::format("parts[{}].anchored", bodies[kMaxBodies]),
        fmt::format("expected at most {} dynamic parts, found {}", kMaxBodies, bodies.size()),
        "anchor the parts that no player pushes");
  }
  for (const uint32_t index : bodies) OBBY_RETURN_IF_ERROR(addAt(parts[index], index));
  return finish();
}

Status PartCompiler::finish() {
  OBBY_RETURN_IF_ERROR(clocks_.checkSignals());
  bool crushes = false;
  for (const Bounds& b : out_.bounds) crushes = crushes || (b.flags & kCrush) != 0;
  if (crushes) clocks_.add({kForever});
  if (params_.airJumps != 0) clocks_.add({kForever});
  out_.clocks = clocks_.finish(own_, out_.colliders, out_.roles, out_.movers);
  auto last = uint32_t(out_.clocks.size());
  if (params_.airJumps != 0) out_.airClock = --last;
  if (crushes) out_.crushClock = --last;
  const Vec3 nowhere{1e38f, 1e38f, 1e38f};
  out_.bounds.push_back(makeBounds({nowhere, -nowhere}, 0, uint32_t(out_.bounds.size()), false));
  return {};
}

}  // namespace

Result<PartTables> compileParts(schema::Level::Reader record, const Params& params) {
  if (record.getParts().size() > kMaxParts) {
    return pathError("parts", fmt::format("expected at most {} parts, found {}", kMaxParts,
                                          record.getParts().size()));
  }
  HullStore hulls;  // found once, even if the other tables are built several times
  for (size_t i = 0;; ++i) {
    PartTables out;
    out.hulls = std::move(hulls);
    PartCompiler compiler(out, params, kMaxTableRows[i]);
    auto status = compiler.compile(record);
    if (status) return out;
    if (!compiler.isOverBudget() || i + 1 == std::size(kMaxTableRows))
      return std::move(status).error();
    hulls = std::move(out.hulls);
  }
}

}  // namespace obby::level
