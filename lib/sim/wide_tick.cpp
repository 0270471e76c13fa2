#include "sim/wide_tick.h"

#include <algorithm>

#include "sim/tick.h"
#include "sim/tick_phases.h"
#include "sim/wide_bodies.h"
#include "sim/wide_parts.h"

namespace obby::sim {
namespace {

using F = WideFloat;

// With fewer worlds, separate lists would leave more lanes empty than they save.
constexpr int kFewWorlds = 100;
constexpr uint32_t kAllLanes = (1u << kLanes) - 1;

class Ticker {
 public:
  Ticker(const level::LevelView& level, WideCounts& counts)
      : level_(level),
        counts_(counts),
        near_(level),
        parts_(level, near_),
        wideBodies_(level, counts.bodiesInLanes) {}

  // Takes at most kWideSlots worlds.
  void run(World* const* worlds, RigidBody* const* bodies, const Action* actions, int count) {
    counts_.ticks += uint64_t(count);
    worlds_ = worlds;
    bodies_ = bodies;
    actions_ = actions;
    admit(count);
    for (int slot = 0; slot < count_; slot += kLanes) play(slot);
    bumpAll();
    wideBodies_.flush();
  }

 private:
  // The kinds of worlds, by the parts that the player can meet: one upright block, one tilted
  // block, or several parts.
  enum Kind { kOneUpright, kOneTilted, kSolids, kKinds };

  void admit(int count);
  void play(int slot);
  uint32_t sortLanes(int slot, uint32_t& free);
  void moveBodies(int index);
  void singly(int index);
  void glide(WideMotion& m) const;
  void bumpAll();
  void bump(const int32_t* slots, uint32_t lanes);
  void put(Rows& rows, const int32_t* slots, uint32_t lanes, uint32_t moved);
  void endTickInLanes(Rows& rows, WideMask skip) const;
  void touch(int index, int footedOn);

  const level::LevelView& level_;
  WideCounts& counts_;

  // These cover all worlds, by index.
  WideNear near_;
  WideParts parts_;
  World* const* worlds_ = nullptr;
  RigidBody* const* bodies_ = nullptr;
  const Action* actions_ = nullptr;
  WideBodies wideBodies_;
  World unused_{};  // lanes without a world write to it

  // These cover the worlds in lanes, by slot, in the order of work. Slots past the end repeat the
  // last world.
  int count_ = 0;
  int32_t order_[kWideSlots + kLanes];        // index of the world in each slot
  alignas(64) int32_t footedOn_[kWideSlots];  // index into the world's tags of the part that the
                                              // feet touch; -1 for none
  LaneSolids solids_[kWideSlots];
  int listed_[kKinds];
  int32_t lists_[kKinds][kWideSlots + kLanes];  // slots
  // Unions leave the arrays uninitialised, because zeroing them in every call is slow.
  union {
    MotionRow motions_[kWideSlots];  // rows of players that are not free
  };
};

// Sorts the worlds for the lanes by the number of parts near them, so that lanes idle less. The
// others take their tick at once.
void Ticker::admit(int count) {
  near_.look(worlds_, bodies_, count);
  int start[kRowWords + 2] = {};
  for (int i = 0; i < count; ++i) {
    if (near_.turn(i) == WideNear::Turn::lanes) ++start[near_.count(i) + 1];
  }
  for (int n = 0; n <= kRowWords; ++n) start[n + 1] += start[n];
  count_ = start[kRowWords + 1];
  std::fill_n(listed_, int(kKinds), 0);
  for (int i = 0; i < count; ++i) {
    if (near_.turn(i) == WideNear::Turn::lanes) order_[start[near_.count(i)]++] = i;
    if (near_.turn(i) == WideNear::Turn::single) singly(i);
  }
  std::fill_n(order_ + count_, kLanes, count_ > 0 ? order_[count_ - 1] : 0);
}

// Advances the players in kLanes slots. bumpAll() does the moves among solid parts.
void Ticker::play(int slot) {
  const int32_t* index = order_ + slot;
  const void* worlds[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) worlds[lane] = worlds_[index[lane]];
  Rows rows = loadRows(worlds);
  WidePlayer player = playerOf(rows);
  const Params& p = level_.params;
  const ControlT<F> controls = controlsOf(actions_, index, p);
  faceAtOnce(player, p, controls);
  parts_.look(index);
  const FloorT<F> floor = parts_.floorUnder(player, worlds_);
  updateState(player, p, floor, controls);
  turn(player, p, floor, controls);
  const DriveT<F> wanted = drive(player, p, floor, controls);
  WideMotion motion = motionOf(player, p, floor, wanted);
  store(footedOn<F>(wanted.hover, floor), footedOn_ + slot);
  parts_.findSolids(motion, solids_ + slot);
  uint32_t free = 0;
  const uint32_t lanes = sortLanes(slot, free);
  if (free != lanes) {
    void* motions[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) motions[lane] = motions_ + slot + lane;
    storeRows(rowsOf(motion, player.yaw), motions);
  }
  if (level_.bodyCount != 0) rows = loadRows(worlds);  // bodies that fell asleep changed its flags
  glide(motion);
  putMoved(player, motion);
  putPlayer(rows, player);
  alignas(64) int32_t slots[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) slots[lane] = slot + lane;
  put(rows, slots, lanes, free);
}

// Sorts worlds by the motion that they need, and adds players who meet nothing to `free`. Moves the
// worlds that lanes cannot take. Returns the others, one bit each, after moving their bodies.
uint32_t Ticker::sortLanes(int slot, uint32_t& free) {
  uint32_t lanes = 0;
  for (int at = slot; at < std::min(slot + kLanes, count_); ++at) {
    const LaneSolids& solids = solids_[at];
    if (solids.count > kLaneSolids) {
      singly(order_[at]);
      continue;
    }
    const uint32_t bit = 1u << (at - slot);
    lanes |= bit;
    if (level_.bodyCount != 0) moveBodies(order_[at]);
    if (solids.count == 0) {
      free |= bit;
      continue;
    }
    int kind = kSolids;
    if (solids.count == 1 && count_ >= kFewWorlds) {
      kind = solids.tags[0] & level::kUprightTag ? kOneUpright : kOneTilted;
    }
    lists_[kind][listed_[kind]++] = at;
    ++counts_.contact;
  }
  return lanes;
}

// Moves the players among solid parts.
void Ticker::bumpAll() {
  for (int kind = 0; kind < kKinds; ++kind) {
    int32_t* list = lists_[kind];
    const int count = listed_[kind];
    if (count == 0) continue;
    std::fill_n(list + count, kLanes, list[count - 1]);
    for (int i = 0; i < count; i += kLanes) {
      bump(list + i, count - i < kLanes ? (1u << (count - i)) - 1 : kAllLanes);
    }
  }
}

// Moves the bodies of a world whose player moves in lanes.
void Ticker::moveBodies(int index) {
  World& w = *worlds_[index];
  if (!(w.flags & kBodyAwake)) return;
  Candidates none;
  none.bodiesApart = wideBodies_.add(w, bodies_[index], near_.reach(index));
  moveTogether(w, bodies_[index], nullptr, {}, level_, none);
}

void Ticker::singly(int index) {
  ++counts_.single;
  World& w = *worlds_[index];
  RigidBody* bodies = bodies_ ? bodies_[index] : nullptr;
  uint32_t apart = 0;
  // Boosts make a player faster than the lanes assume.
  if ((w.flags & kBodyAwake) && w.clockCount == 0) {
    apart = wideBodies_.add(w, bodies, near_.reach(index));
  }
  tick(w, bodies, level_, actions_[index], apart);
}

// Moves players who meet nothing, by one tick.
void Ticker::glide(WideMotion& m) const {
  const Params& p = level_.params;
  const WideMask constant = isConstant(m, p);
  WideMotion stepped = m;
  integrate<F>(m, level_, p.substepSeconds, p.substeps);
  if (all(constant)) return;
  for (int s = 0; s < p.substeps; ++s) {
    accelerate<F>(stepped, level_, p.substepSeconds);
    stepped.position += stepped.velocity * F(p.substepSeconds);
  }
  m.position = select(constant, m.position, stepped.position);
  m.velocity = select(constant, m.velocity, stepped.velocity);
}

void Ticker::bump(const int32_t* slots, uint32_t lanes) {
  const LaneSolids* solids[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) solids[lane] = solids_ + slots[lane];
  const Obstacles obstacles = parts_.obstacles(solids);
  const void *motions[kLanes], *worlds[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    motions[lane] = motions_ + slots[lane];
    worlds[lane] = worlds_[order_[slots[lane]]];
  }
  WideMotion m = motionAt(loadRows(motions), level_.params.gravity);
  for (int s = 0; s < level_.params.substeps; ++s) {
    accelerate<F>(m, level_, level_.params.substepSeconds);
    moveAmong(m, level_.params, obstacles, level_.params.substepSeconds);
  }
  Rows rows = loadRows(worlds);
  WidePlayer player = playerOf(rows);
  putMoved(player, m);
  putPlayer(rows, player);
  put(rows, slots, lanes, lanes);
}

// Stores the worlds of `lanes`, and ends the tick of those in `moved`. Worlds where nothing can be
// touched do endTick() of tick_phases.h in lanes.
void Ticker::put(Rows& rows, const int32_t* slots, uint32_t lanes, uint32_t moved) {
  void* targets[kLanes];
  alignas(64) int32_t skip[kLanes];
  uint32_t touching = 0;
  for (int lane = 0; lane < kLanes; ++lane) {
    const int index = order_[slots[lane]];
    const uint32_t bit = 1u << lane, touches = near_.anyFlags(index) & level::kTouchRoles;
    targets[lane] = lanes & bit ? worlds_[index] : &unused_;
    if (touches != 0) touching |= bit;
    skip[lane] = touches != 0 || !(moved & bit);
  }
  endTickInLanes(rows, load(skip) != WideInt(0));
  storeRows(rows, targets);
  for (uint32_t left = touching & moved; left != 0; left &= left - 1) {
    const int slot = slots[lowestBit(left)];
    touch(order_[slot], footedOn_[slot]);
  }
}

void Ticker::endTickInLanes(Rows& rows, WideMask skip) const {
  const Params& p = level_.params;
  const WideInt hurt = (rows.word[kFloorlessHurtWord] >> 16) & 0xffff;
  const WideInt calmed = (rows.word[kFloorlessHurtWord] & 0xffff) | ((hurt - 1) << 16);
  rows.word[kFloorlessHurtWord] =
      select(skip | (hurt == WideInt(0)), rows.word[kFloorlessHurtWord], calmed);
  const F health = floatOfBits(rows.word[kHealthWord]);
  rows.word[kHealthWord] = bitsOf(select(skip, health, regenerated<F>(health, p)));
  rows.word[kTickWord] = rows.word[kTickWord] + select(skip, WideInt(0), WideInt(1));
  const F height = floatOfBits(rows.word[kPositionWord + 1]);
  const WideMask fell = (height < p.fallenPartsHeight) & !skip;
  const int32_t ended = int32_t(State::dead) << 16 | int32_t(Outcome::fell) << 24;
  rows.word[kStateWord] =
      select(fell, (rows.word[kStateWord] & 0xffff) | ended, rows.word[kStateWord]);
}

void Ticker::touch(int index, int footedOn) {
  Candidates near;
  near.footedOn = footedOn;
  for (int k = 0; k < near_.count(index); ++k) {
    const uint32_t tag = near_.tags(index)[k], id = near_.colliderOf(tag);
    const Pose& pose = near_.poseOf(tag);
    const Box bounds = boundsOf(pose, level_.colliders[id].shape.half);
    near.items[near.count++] = {bounds, &pose, id, level_.bounds[id].flags};
  }
  near.anyFlags = near_.anyFlags(index);
  endTick(*worlds_[index], level_, near);
}

}  // namespace

void tickAll(const level::LevelView& level, World* const* worlds, RigidBody* const* bodies,
             const Action* actions, size_t count, WideCounts* counts) {
  WideCounts unused;
  Ticker ticker(level, counts != nullptr ? *counts : unused);
  for (size_t first = 0; first < count; first += kWideSlots) {
    const int some = int(std::min(count - first, size_t(kWideSlots)));
    ticker.run(worlds + first, bodies ? bodies + first : nullptr, actions + first, some);
  }
}

}  // namespace obby::sim
