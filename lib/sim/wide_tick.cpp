#include "sim/wide_tick.h"

#include <algorithm>

#include "sim/tick.h"
#include "sim/tick_phases.h"
#include "sim/wide_contact.h"
#include "sim/wide_loose.h"
#include "sim/wide_near.h"

namespace obby::sim {
namespace {

using F = WideFloat;

// Fewer worlds than these would leave more lanes empty in lists of their own than they save there.
constexpr int kFewWorlds = 100;

class Ticker {
 public:
  Ticker(const level::LevelView& level, WideCounts& counts)
      : level_(level), counts_(counts), near_(level), bodies_(level, counts.looseInLanes) {}

  // At most kWideSlots worlds.
  void run(World* const* worlds, LooseBody* const* loose, const Action* actions, int count) {
    counts_.ticks += uint64_t(count);
    worlds_ = worlds;
    loose_ = loose;
    actions_ = actions;
    admit(count);
    for (int slot = 0; slot < count_; slot += kLanes) decide(slot);
    moveAll();
    moveLoose();
    for (int slot = 0; slot < count_; slot += kLanes) finish(slot);
  }

 private:
  void admit(int count);
  void decide(int slot);
  FloorT<F> sense(const WidePlayer& player, const int32_t* index);
  void addSurface(WideInt nearest, int most, const int32_t* index, FloorT<F>& floor) const;
  void findSolids(const WideMotion& motion, int slot, int most);
  void moveAll();
  void moveLoose();
  void singly(int index);
  void glide(const int32_t* slots, bool atOnce);
  void bump(const int32_t* slots);
  Obstacles obstaclesOf(const int32_t* slots) const;
  void finish(int slot);
  void endTickInLanes(Rows& rows, WideMask touching) const;
  void touch(int index, int footedOn);

  const level::LevelView& level_;
  WideCounts& counts_;

  // Of all worlds: by index.
  WideNear near_;
  World* const* worlds_ = nullptr;
  LooseBody* const* loose_ = nullptr;
  const Action* actions_ = nullptr;
  WideLoose bodies_;

  // Of the worlds in lanes, in the order of work: by slot. The slots after the last repeat it.
  int count_ = 0;
  int32_t order_[kWideSlots + kLanes];  // index
  alignas(64) int32_t solidCount_[kWideSlots];
  alignas(64) int32_t footedOn_[kWideSlots];  // place in the tags of the world; -1: none
  uint32_t solids_[kWideSlots][kLaneSolids];  // tags
  bool constant_[kWideSlots];
  bool done_[kWideSlots];  // by tick()
  MotionTable<kWideSlots> motions_;
  // Unions keep the arrays from being zeroed for every call.
  union {
    WidePlayer players_[kWideSlots / kLanes];  // without position and velocity
  };

  // Parts near the lanes in work.
  union {
    WideBlock blocks_[kRowWords];
  };
  union {
    WideInt tags_[kRowWords];
  };
};

// Puts the worlds for the lanes in order: those with as many parts near them go together, so that
// lanes idle less. The others take their tick at once.
void Ticker::admit(int count) {
  near_.look(worlds_, loose_, count);
  int start[kRowWords + 2] = {};
  for (int i = 0; i < count; ++i) {
    if (near_.turn(i) == WideNear::Turn::lanes) ++start[near_.count(i) + 1];
  }
  for (int n = 0; n <= kRowWords; ++n) start[n + 1] += start[n];
  count_ = start[kRowWords + 1];
  for (int i = 0; i < count; ++i) {
    if (near_.turn(i) == WideNear::Turn::lanes) order_[start[near_.count(i)]++] = i;
    if (near_.turn(i) == WideNear::Turn::single) singly(i);
  }
  std::fill_n(order_ + count_, kLanes, count_ > 0 ? order_[count_ - 1] : 0);
}

ControlT<F> controlsOf(const Action* actions, const int32_t* index) {
  alignas(64) int32_t heading[kLanes], walk[kLanes], jump[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const Action& a = actions[index[lane]];
    heading[lane] = a.heading;
    walk[lane] = a.walk;
    jump[lane] = a.jump;
  }
  return {load(heading), load(walk) != WideInt(0), load(jump) != WideInt(0)};
}

// The players' will, and the motions to be made.
void Ticker::decide(int slot) {
  const int32_t* index = order_ + slot;
  const void* worlds[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) worlds[lane] = worlds_[index[lane]];
  WidePlayer player = playerOf(loadRows(worlds));
  const ControlT<F> controls = controlsOf(actions_, index);
  faceAtOnce(player, level_.params, controls);
  const FloorT<F> floor = sense(player, index);
  updateState(player, level_.params, floor, controls);
  turn(player, level_.params, floor, controls);
  const DriveT<F> wanted = drive(player, level_.params, floor, controls);
  const WideMotion motion = motionOf(player, level_.params, floor, wanted);
  store(footedOn<F>(wanted.hover, floor), footedOn_ + slot);
  players_[slot / kLanes] = player;
  motions_.put(slot, motion);
  findSolids(motion, slot, near_.count(index[kLanes - 1]));
}

// What the players stand on. Leaves the parts near these lanes in blocks_ and tags_.
FloorT<F> Ticker::sense(const WidePlayer& player, const int32_t* index) {
  FloorRaysT<F> rays = makeRays(player, level_.params);
  const BoxT<F> box = boundsOf(rays);
  const void* rows[kLanes];
  alignas(64) int32_t near[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    rows[lane] = near_.tags(index[lane]);
    near[lane] = near_.count(index[lane]);
  }
  const Rows tags = loadRows(rows);
  const int most = near[kLanes - 1];
  for (int k = 0; k < most; ++k) {
    alignas(64) int32_t tag[kLanes];
    tags_[k] = select(load(near) > k, tags.word[k], WideInt(0));
    store(tags_[k], tag);
    for (int lane = 0; lane < kLanes; ++lane) rows[lane] = near_.rowOf(uint32_t(tag[lane]));
    blocks_[k] = blockOf(loadRows(rows));
    const WideMask asked = ((tags_[k] & int32_t(level::kSolidTag)) != 0) &
                           overlaps(boundsOf(blocks_[k].pose, blocks_[k].half), box);
    if (!any(asked)) continue;
    const WideMask upright = (tags_[k] & int32_t(level::kUprightTag)) != 0;
    if (any(asked & upright)) castAtUpright<F>(rays, blocks_[k], k, asked & upright);
    if (any(asked & !upright)) castAtTilted<F>(rays, blocks_[k], k, asked & !upright);
  }
  FloorT<F> floor = averageOf(rays, level_.params);
  addSurface(rays.nearest, most, index, floor);
  return floor;
}

// Friction and motion of what the players stand on.
void Ticker::addSurface(WideInt nearest, int most, const int32_t* index, FloorT<F>& floor) const {
  floor.grip = level_.params.plainGrip;
  WideMask special;
  for (int k = 0; k < most; ++k) {
    special |= (nearest == k) & ((tags_[k] & int32_t(level::kSurfaceTag)) != 0);
  }
  if (!any(special)) return;
  alignas(64) int32_t part[kLanes];
  alignas(64) float values[5][kLanes] = {};
  store(nearest, part);
  for (uint32_t left = bitsOf(special); left != 0; left &= left - 1) {
    const int lane = lowestBit(left);
    const uint32_t tag = near_.tags(index[lane])[part[lane]], id = near_.colliderOf(tag);
    Floor one;
    surfaceMotion(*worlds_[index[lane]], nullptr, level_,
                  {{}, &near_.poseOf(tag), id, level_.bounds[id].flags}, one);
    const float found[5] = {level_.colliders[id].grip, one.velocity.x, one.velocity.y,
                            one.velocity.z, one.turning};
    for (int v = 0; v < 5; ++v) values[v][lane] = found[v];
  }
  floor.grip = select(special, load(values[0]), floor.grip);
  floor.velocity = {load(values[1]), load(values[2]), load(values[3])};
  floor.turning = load(values[4]);
}

// Solid parts that the bodies can meet during this tick, from blocks_.
void Ticker::findSolids(const WideMotion& motion, int slot, int most) {
  const BoxT<F> reach = bodyReach(motion, level_.params);
  std::fill_n(solidCount_ + slot, kLanes, 0);
  for (int k = 0; k < most; ++k) {
    const WideBlock& block = blocks_[k];
    const WideMask solid = (tags_[k] & int32_t(level::kSolidTag)) != 0;
    const WideMask meets =
        solid & overlaps(boundsOf(block.pose, block.half), reach) & meetsBlock<F>(reach, block);
    for (uint32_t left = bitsOf(meets); left != 0; left &= left - 1) {
      const int at = slot + lowestBit(left);
      const int32_t n = solidCount_[at]++;
      if (n < kLaneSolids) solids_[at][n] = near_.tags(order_[at])[k];
    }
  }
  // The very fast take smaller steps: tick() knows how.
  const WideMask fast = substepTravel(motion, level_.params) > safeTravel(motion, level_.params);
  for (uint32_t left = bitsOf(fast); left != 0; left &= left - 1) {
    int32_t& n = solidCount_[slot + lowestBit(left)];
    if (n > 0) n = kLaneSolids + 1;
  }
  const uint32_t bits = bitsOf(isConstant(motion, level_.params));
  for (int lane = 0; lane < kLanes; ++lane) constant_[slot + lane] = (bits >> lane & 1) != 0;
}

// Sorts the worlds by what their motion needs and moves them.
void Ticker::moveAll() {
  enum { kOneStep, kSubsteps, kOneUpright, kOneTilted, kSolids, kLists };
  alignas(64) int32_t lists[kLists][kWideSlots + kLanes];
  int counts[kLists] = {};
  for (int slot = 0; slot < count_; ++slot) {
    const int32_t solids = solidCount_[slot];
    done_[slot] = solids > kLaneSolids;
    if (done_[slot]) {
      singly(order_[slot]);
      continue;
    }
    int list = constant_[slot] ? kOneStep : kSubsteps;
    if (solids == 1) list = solids_[slot][0] & level::kUprightTag ? kOneUpright : kOneTilted;
    if (solids > 1 || (solids == 1 && count_ < kFewWorlds)) list = kSolids;
    lists[list][counts[list]++] = slot;
  }
  counts_.contact += uint64_t(counts[kOneUpright] + counts[kOneTilted] + counts[kSolids]);
  for (int list = 0; list < kLists; ++list) {
    if (counts[list] == 0) continue;
    std::fill_n(lists[list] + counts[list], kLanes, lists[list][counts[list] - 1]);
    for (int i = 0; i < counts[list]; i += kLanes) {
      const int32_t* slots = lists[list] + i;
      if (list == kOneStep) glide(slots, true);
      if (list == kSubsteps) glide(slots, false);
      if (list > kSubsteps) bump(slots);
    }
  }
}

// The bodies of worlds whose player has moved in lanes.
void Ticker::moveLoose() {
  if (level_.looseCount == 0) return;
  for (int slot = 0; slot < count_; ++slot) {
    const int index = order_[slot];
    World& w = *worlds_[index];
    if (done_[slot] || !(w.flags & kLooseAwake)) continue;
    Candidates none;
    none.looseApart = bodies_.add(w, loose_[index], near_.reach(index));
    moveTogether(w, loose_[index], nullptr, {}, level_, none);
  }
  bodies_.flush();
}

void Ticker::singly(int index) {
  ++counts_.single;
  World& w = *worlds_[index];
  LooseBody* loose = loose_ ? loose_[index] : nullptr;
  uint32_t apart = 0;
  // Boosts make a player faster than the lanes know.
  if ((w.flags & kLooseAwake) && w.clockCount == 0) {
    apart = bodies_.add(w, loose, near_.reach(index));
  }
  tick(w, loose, level_, actions_[index], apart);
}

void Ticker::glide(const int32_t* slots, bool atOnce) {
  WideMotion m = motions_.take(slots);
  const Params& p = level_.params;
  if (atOnce) {
    integrate<F>(m, level_, p.substepSeconds, p.substeps);
  } else {
    for (int s = 0; s < p.substeps; ++s) {
      accelerate<F>(m, level_, p.substepSeconds);
      m.position += m.velocity * F(p.substepSeconds);
    }
  }
  motions_.putMoved(slots, m);
}

Obstacles Ticker::obstaclesOf(const int32_t* slots) const {
  Obstacles o;
  alignas(64) int32_t counts[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) counts[lane] = solidCount_[slots[lane]];
  o.count = load(counts);
  o.most = *std::max_element(counts, counts + kLanes);
  for (int k = 0; k < o.most; ++k) {
    const void* rows[kLanes];
    alignas(64) int32_t upright[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const uint32_t tag = k < counts[lane] ? solids_[slots[lane]][k] : 0;
      rows[lane] = near_.rowOf(tag);
      upright[lane] = int32_t(tag & level::kUprightTag);
    }
    o.block[k] = blockOf(loadRows(rows));
    o.bounds[k] = boundsOf(o.block[k].pose, o.block[k].half);
    o.upright[k] = load(upright) != WideInt(0);
  }
  return o;
}

void Ticker::bump(const int32_t* slots) {
  const Obstacles obstacles = obstaclesOf(slots);
  WideMotion m = motions_.take(slots);
  for (int s = 0; s < level_.params.substeps; ++s) {
    accelerate<F>(m, level_, level_.params.substepSeconds);
    moveAmong(m, level_.params, obstacles, level_.params.substepSeconds);
  }
  motions_.putMoved(slots, m);
}

// endTick() of tick_phases.h, in lanes where nothing can be touched.
void Ticker::finish(int slot) {
  World unused{};
  World* targets[kLanes];
  alignas(64) int32_t touching[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const int at = slot + lane, index = order_[at];
    const bool live = at < count_ && !done_[at];
    targets[lane] = live ? worlds_[index] : &unused;
    touching[lane] = live && (near_.anyFlags(index) & level::kTouchRoles);
  }
  Rows rows = loadRows(reinterpret_cast<const void* const*>(targets));
  WidePlayer player = players_[slot / kLanes];
  player.position = motions_.position(slot);
  player.velocity = motions_.velocity(slot);
  player.lifted = motions_.lifts(slot);
  putPlayer(rows, player);
  endTickInLanes(rows, load(touching) != WideInt(0));
  storeRows(rows, reinterpret_cast<void* const*>(targets));
  for (int lane = 0; lane < kLanes; ++lane) {
    if (touching[lane]) touch(order_[slot + lane], footedOn_[slot + lane]);
  }
}

void Ticker::endTickInLanes(Rows& rows, WideMask touching) const {
  const Params& p = level_.params;
  const WideInt hurt = (rows.word[kFloorlessHurtWord] >> 16) & 0xffff;
  const WideInt calmed = (rows.word[kFloorlessHurtWord] & 0xffff) | ((hurt - 1) << 16);
  rows.word[kFloorlessHurtWord] =
      select(touching | (hurt == WideInt(0)), rows.word[kFloorlessHurtWord], calmed);
  const F health = floatOfBits(rows.word[kHealthWord]);
  rows.word[kHealthWord] = bitsOf(select(touching, health, regenerated<F>(health, p)));
  rows.word[kTickWord] = rows.word[kTickWord] + select(touching, WideInt(0), WideInt(1));
  const F height = floatOfBits(rows.word[kPositionWord + 1]);
  const WideMask fell = (height < p.fallenPartsHeight) & !touching;
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

void tickAll(const level::LevelView& level, World* const* worlds, LooseBody* const* loose,
             const Action* actions, size_t count, WideCounts* counts) {
  WideCounts unused;
  Ticker ticker(level, counts != nullptr ? *counts : unused);
  for (size_t first = 0; first < count; first += kWideSlots) {
    const int some = int(std::min(count - first, size_t(kWideSlots)));
    ticker.run(worlds + first, loose ? loose + first : nullptr, actions + first, some);
  }
}

}  // namespace obby::sim
