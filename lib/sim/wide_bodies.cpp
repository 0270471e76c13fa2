#include "sim/wide_bodies.h"

#include <algorithm>
#include <bit>

#include "sim/reach.h"
#include "sim/wide_state.h"

namespace obby::sim {
namespace {

using F = WideFloat;

// These read and write the words of rows.
QuatT<F> quatAt(const Rows& rows, int word) {
  return {floatOfBits(rows.word[word]), floatOfBits(rows.word[word + 1]),
          floatOfBits(rows.word[word + 2]), floatOfBits(rows.word[word + 3])};
}
void putQuat(Rows& rows, int word, const QuatT<F>& q) {
  putVector(rows, word, {q.x, q.y, q.z});
  rows.word[word + 3] = bitsOf(q.w);
}
Mat3T<F> matrixAt(const Rows& rows, int word) {
  return {vectorAt(rows, word), vectorAt(rows, word + 3), vectorAt(rows, word + 6)};
}

// Words of a body's row.
enum BodyWord {
  kPlace = 0,
  kRotation = 3,
  kSpeed = 7,
  kSpin = 10,
  kRest = 13,
  kRadius,
  kInverseMass
};
constexpr int kCenter = 9, kRestless = 12, kTouches = 13;  // words of a mass's row
constexpr int kMargin = 15;                                // word of a block's row
static_assert(offsetof(RigidBody, rotation) == 4 * kRotation &&
              offsetof(RigidBody, velocity) == 4 * kSpeed &&
              offsetof(RigidBody, spin) == 4 * kSpin &&
              offsetof(RigidBody, stillTicks) == 4 * kRest);

// Loads rows of `count` items from `first` on. The last item is repeated past the end.
template <class RowOf>
Rows loadFrom(int first, int count, RowOf&& rowOf) {
  const void* rows[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) rows[lane] = rowOf(std::min(first + lane, count - 1));
  return loadRows(rows);
}

}  // namespace

uint32_t WideBodies::add(World& w, RigidBody* bodies, const Box& near) {
  const int max = int(level_.bodyCount);
  if (counts_.bodies + max > kBodies || counts_.pairs + max * kMaxContacts > kPairs) flush();
  float speeds[level::kMaxBodies];
  const uint32_t apart = findApart(bodies, speeds);
  uint32_t taken = 0;
  for (uint32_t i = 0; i < level_.bodyCount; ++i) {
    const RigidBody& b = bodies[i];
    if (b.state != RigidBodyState::awake || !(apart >> i & 1)) continue;
    if (isNear(b, level_.bodies[i], near)) continue;
    const Counts before = counts_;
    if (take(w, bodies[i], i, speeds[i])) {
      taken |= 1u << i;
    } else {
      counts_ = before;
    }
  }
  if (taken != 0) owners_[counts_.worlds++] = {&w, bodies};
  taken_ += uint64_t(std::popcount(taken));
  return taken;
}

// Returns the bodies that are too far from all others to meet them, one bit each. Sets `speeds` for
// all bodies. It may miss bodies that isAlone() finds, because finding those takes more square
// roots.
uint32_t WideBodies::findApart(const RigidBody* bodies, float* speeds) const {
  constexpr float kRounding = 0.01f;  // studs
  uint32_t meets = 0;
  for (uint32_t i = 0; i < level_.bodyCount; ++i) {
    speeds[i] = length(bodies[i].velocity);
    for (uint32_t k = 0; k < i; ++k) {
      const Vec3 d = bodies[k].position - bodies[i].position;
      const float reach = level_.bodies[i].radius + level_.bodies[k].radius + kRounding +
                          contactMargin(level_.params, speeds[i] + speeds[k]);
      const bool gone =
          bodies[i].state == RigidBodyState::gone || bodies[k].state == RigidBodyState::gone;
      if (!gone && dot(d, d) <= reach * reach) meets |= 1u << i | 1u << k;
    }
  }
  return ~meets;
}

// Adds a body and the parts that it may meet. Returns false if lanes cannot take the body.
bool WideBodies::take(const World& w, RigidBody& b, uint32_t i, float speed) {
  const level::DynamicBody& l = level_.bodies[i];
  const level::Collider& own = level_.colliders[l.firstCollider];
  if (l.colliderCount != 1 || !geom::isBlock(own.kind)) return false;
  const float margin = contactMargin(level_.params, speed);
  const Box near = reachOf(b.position, l, margin);
  const int firstPair = counts_.pairs;
  bool restless = false;
  uint32_t ids[kMaxNear + level::kListStep];
  const int found = partsNear(b.position, near, ids);
  for (int k = 0; k < found; ++k) {
    if (!takePart(w, ids[k], near, restless)) return false;
  }
  if (found > int(kMaxNear)) return false;
  if (counts_.pairs - firstPair > kMaxContacts) return false;
  const int at = counts_.bodies++;
  bodies_[at] = {b, l.radius, l.inverseMass};
  masses_[at] = {l.inverseInertia, l.center, restless, 0, {}};
  blocks_[at].half = own.shape.half;
  blocks_[at].margin = margin;
  places_[at] = {&b, l.firstCollider, i, 0, 0};
  for (int k = firstPair; k < counts_.pairs; ++k) added_[k].body = at;
  return true;
}

// Returns the number of parts whose bounds meet the box; a result above kMaxNear means too many.
// There is no branch for each part, because it would be mispredicted.
int WideBodies::partsNear(Vec3 center, const Box& near, uint32_t* ids) const {
  const int32_t cell = cellOf<float>(level_.bodyGrid, center);
  if (cell < 0) return 0;
  const uint32_t* list = level_.bodyGrid.lists + level_.bodyGrid.cells[cell];
  const Reach reach(near);
  uint32_t found = 0;
  for (uint32_t k = 1; k <= list[0] && found <= kMaxNear; k += level::kListStep) {
    for (uint32_t j = k; j < k + level::kListStep; ++j) {
      ids[found] = list[j];
      found += reach.meets(level_.bounds[list[j]]);
    }
  }
  return int(found);
}

bool WideBodies::takePart(const World& w, uint32_t id, const Box& near, bool& restless) {
  const level::Bounds& bounds = level_.bounds[id];
  if (!(bounds.flags & level::kSolid)) return true;
  const level::Collider& c = level_.colliders[id];
  const uint32_t flags = bounds.flags;
  restless |= isRestless(flags);
  if (hasLeft(w, level_, c, flags)) return true;
  if (!geom::isBlock(c.kind) || counts_.pairs == kPairs) return false;
  Pair pair{0, id, flags, &c, nullptr};
  if (flags & level::kMoving) {
    if (counts_.moved == kMoved) return false;
    MovedPart& moved = moved_[counts_.moved];
    moved.now.pose = poseOf(level_.movers[c.mover], w, 1);
    moved.now.half = c.shape.half;
    moved.before = poseOf(level_.movers[c.mover], w, 0);
    if (!overlaps(boundsOf(moved.now.pose, c.shape.half), near)) return true;
    pair.row = &moved.now;
    pair.before = &moved.before;
    ++counts_.moved;
  }
  added_[counts_.pairs++] = pair;
  return true;
}

void WideBodies::flush() {
  if (counts_.bodies > 0) {
    placeBlocks();
    sortPairs();
    findHits();
    findContacts();
    solve();
  }
  put();
  counts_ = {};
}

// Computes the poses of the bodies' blocks.
void WideBodies::placeBlocks() {
  for (int i = 0; i < counts_.bodies; i += kLanes) {
    const Rows body = loadFrom(i, counts_.bodies, [this](int k) { return &bodies_[k]; });
    const Rows mass = loadFrom(i, counts_.bodies, [this](int k) { return &masses_[k]; });
    const Mat3T<F> axes = toMat3(quatAt(body, kRotation));
    Rows block = loadFrom(i, counts_.bodies, [this](int k) { return &blocks_[k]; });
    putVector(block, 0, vectorAt(body, kPlace) - axes * vectorAt(mass, kCenter));
    putVector(block, 3, axes.x);
    putVector(block, 6, axes.y);
    putVector(block, 9, axes.z);
    void* rows[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) rows[lane] = &blocks_[i + lane];
    storeRows(block, rows);
  }
}

// Sorts pairs by the number of the body. The same body is likely to be in the same place in many
// worlds, and then lanes do the same. Pairs of a body stay together, in their order.
void WideBodies::sortPairs() {
  int start[level::kMaxBodies + 1] = {};
  const auto numberOf = [this](int pair) { return places_[added_[pair].body].number; };
  for (int k = 0; k < counts_.pairs; ++k) ++start[numberOf(k) + 1];
  for (int n = 0; n < level::kMaxBodies; ++n) start[n + 1] += start[n];
  for (int k = 0; k < counts_.pairs; ++k) pairs_[start[numberOf(k)]++] = added_[k];
}

// Finds the pairs that are close enough to touch within the tick.
void WideBodies::findHits() {
  hits_ = 0;
  for (int i = 0; i < counts_.pairs; i += kLanes) {
    const Rows own = loadFrom(i, counts_.pairs, [this](int k) { return &blocks_[pairs_[k].body]; });
    const Rows part = loadFrom(i, counts_.pairs, [this](int k) { return pairs_[k].row; });
    const F margin = floatOfBits(own.word[kMargin]);
    const auto s = geom::blocksApart<F>(blockOf(own), blockOf(part), margin);
    store(s.distance, distance_ + i);
    store(s.normal.x, normal_[0] + i);
    store(s.normal.y, normal_[1] + i);
    store(s.normal.z, normal_[2] + i);
    for (uint32_t left = bitsOf(s.distance <= margin); left != 0; left &= left - 1) {
      const int pair = i + lowestBit(left);
      if (pair < counts_.pairs) touching_[hits_++] = pair;
    }
  }
  std::fill_n(touching_ + hits_, kLanes, hits_ > 0 ? touching_[hits_ - 1] : 0);
}

// Finds the points where the pairs of findHits() touch, one row per pair.
void WideBodies::findContacts() {
  for (int i = 0; i < hits_; i += kLanes) {
    const int32_t* pairs = touching_ + i;
    const Rows own = loadFrom(0, kLanes, [&](int k) { return &blocks_[pairs_[pairs[k]].body]; });
    const Rows part = loadFrom(0, kLanes, [&](int k) { return pairs_[pairs[k]].row; });
    const geom::SeparationT<F> s{obby::gather(distance_, pairs),
                                 {obby::gather(normal_[0], pairs), obby::gather(normal_[1], pairs),
                                  obby::gather(normal_[2], pairs)}};
    const auto m =
        geom::blockManifold<F>(blockOf(own), blockOf(part), s, floatOfBits(own.word[kMargin]));
    Rows out[2];
    putVector(out[0], 0, m.normal);
    out[0].word[3] = m.count;
    for (int k = 0; k < geom::kMaxPoints; ++k) {
      Rows& half = out[k / 3];
      putVector(half, (4 + 4 * k) % kRowWords, m.points[k].position);
      half.word[(7 + 4 * k) % kRowWords] = bitsOf(m.points[k].distance);
    }
    void* rows[kLanes];
    for (int r = 0; r < 2; ++r) {
      for (int lane = 0; lane < kLanes; ++lane) {
        rows[lane] = reinterpret_cast<char*>(&rows_[i + lane]) + 64 * r;
      }
      storeRows(out[r], rows);
    }
    for (int k = i; k < std::min(i + kLanes, hits_); ++k) finishContact(k);
  }
}

// Completes a contact outside the lanes: edge contacts, materials, and the part's motion.
void WideBodies::finishContact(int hit) {
  ContactRow& row = rows_[hit];
  const int at = touching_[hit];
  const Pair& pair = pairs_[at];
  const BlockRow& block = blocks_[pair.body];
  Place& place = places_[pair.body];
  const level::Collider &own = level_.colliders[place.collider],
                        &c = level_.colliders[pair.collider];
  const Pose& pose = *static_cast<const Pose*>(pair.row);
  if (row.count == 0) {
    const geom::Manifold m = geom::manifold(convexOf(own, block.pose), convexOf(c, pose),
                                            {distance_[at], row.normal}, block.margin);
    row.count = m.count;
    std::copy_n(m.points, geom::kMaxPoints, row.points);
  }
  row.friction = 0.5f * (own.friction + c.friction);
  row.bounce = 0.5f * (own.elasticity + c.elasticity);
  row.comes = 0;
  row.surface = {};
  if (pair.flags & (level::kMoving | level::kConveyor)) addMotion(row, pair);
  if (place.contacts++ == 0) place.firstContact = hit;
  masses_[pair.body].touches |= row.count;
}

void WideBodies::addMotion(ContactRow& row, const Pair& pair) {
  const level::Collider& c = level_.colliders[pair.collider];
  const Pose& pose = *static_cast<const Pose*>(pair.row);
  const Partner part{convexOf(c, pose), kPart, &c, pair.flags, pair.before ? *pair.before : pose};
  geom::Manifold m;
  m.count = row.count;
  std::copy_n(row.points, geom::kMaxPoints, m.points);
  const Vec3 middle = middleOf<float>(m), moved = movedBy(level_, part, middle);
  row.surface = surfaceOf(level_, part, middle, row.normal, moved);
  row.comes = dot(moved, row.normal);
}

// Groups bodies with the same number of contacts, and among those the same body of all worlds.
void WideBodies::solve() {
  constexpr int kKeys = (kMaxContacts + 1) * level::kMaxBodies;
  int start[kKeys + 1] = {};
  int32_t order[kBodies + kLanes];
  const auto keyOf = [this](int i) {
    return places_[i].contacts * level::kMaxBodies + int(places_[i].number);
  };
  for (int i = 0; i < counts_.bodies; ++i) ++start[keyOf(i) + 1];
  for (int n = 0; n < kKeys; ++n) start[n + 1] += start[n];
  for (int i = 0; i < counts_.bodies; ++i) order[start[keyOf(i)]++] = i;
  std::fill_n(order + counts_.bodies, kLanes, order[counts_.bodies - 1]);
  for (int i = 0; i < counts_.bodies; i += kLanes) {
    solve(order + i, places_[order[i + kLanes - 1]].contacts);
  }
}

// Returns the k-th contacts of bodies. A body that has fewer gets one without points.
WideContact WideBodies::contactOf(const int32_t* bodies, int k, const RigidT<F>& body) const {
  static constexpr ContactRow kNone{};
  const void* rows[2][kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const Place& place = places_[bodies[lane]];
    const ContactRow& row = k < place.contacts ? rows_[place.firstContact + k] : kNone;
    rows[0][lane] = &row;
    rows[1][lane] = reinterpret_cast<const char*>(&row) + sizeof row / 2;
  }
  const Rows in[2] = {loadRows(rows[0]), loadRows(rows[1])};
  geom::ManifoldT<F> m;
  m.normal = vectorAt(in[0], 0);
  m.count = in[0].word[3];
  for (int i = 0; i < geom::kMaxPoints; ++i) {
    const int word = 4 + 4 * i;
    const Rows& half = in[word / kRowWords];
    m.points[i] = {vectorAt(half, word % kRowWords), floatOfBits(half.word[word % kRowWords + 3])};
  }
  WideContact c;
  c.normal = m.normal;
  c.friction = floatOfBits(in[1].word[4]);
  c.bounce = floatOfBits(in[1].word[5]);
  c.comes = floatOfBits(in[1].word[6]);
  c.surface = vectorAt(in[1], 7);
  const RigidT<F>* const own[1] = {&body};
  prepare<F, 1>(c, own, pairOf(body, c), m, middleOf<F>(m), level_.params.tickSeconds);
  return c;
}

// Advances kLanes bodies by one tick, with at most `contacts` each.
void WideBodies::solve(const int32_t* bodies, int contacts) {
  const Params& p = level_.params;
  Rows row = loadFrom(0, kLanes, [&](int k) { return &bodies_[bodies[k]]; });
  const Rows mass = loadFrom(0, kLanes, [&](int k) { return &masses_[bodies[k]]; });
  BodyLanes lanes(p, rigidOf<F>(vectorAt(row, kPlace), vectorAt(row, kSpeed), vectorAt(row, kSpin),
                                quatAt(row, kRotation), matrixAt(mass, 0),
                                floatOfBits(row.word[kInverseMass])));
  for (int k = 0; k < contacts; ++k) lanes.add(contactOf(bodies, k, lanes.body()));
  lanes.run();
  const RigidT<F>& b = lanes.body();
  const WideMask restless = (mass.word[kRestless] != 0) | (mass.word[kTouches] == WideInt(0));
  const WideInt still =
      stillTicksOf<F>(b, floatOfBits(row.word[kRadius]), restless, row.word[kRest] & 0xffff, p);
  const WideMask tired = still >= WideInt(p.sleepTicks), fell = b.position.y < p.fallenPartsHeight;
  const auto state = [](RigidBodyState s) { return WideInt(int32_t(s) << 16); };
  row.word[kRest] = still | select(tired, state(RigidBodyState::asleep),
                                   select(fell, state(RigidBodyState::gone), WideInt(0)));
  putVector(row, kPlace, b.position);
  putVector(row, kSpeed, select(tired, Vec3T<F>{}, limited(b.velocity, p.maxFallSpeed)));
  putVector(row, kSpin, select(tired, Vec3T<F>{}, limited(b.spin, kMaxSpin)));
  putQuat(row, kRotation, b.rotation);
  void* rows[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) rows[lane] = &bodies_[bodies[lane]];
  storeRows(row, rows);
}

void WideBodies::put() {
  for (int i = 0; i < counts_.bodies; ++i) *places_[i].target = bodies_[i].body;
  for (int i = 0; i < counts_.worlds; ++i) noteAwake(*owners_[i].world, owners_[i].bodies, level_);
}

}  // namespace obby::sim
