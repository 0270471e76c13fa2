// Dynamic bodies of many worlds at once. A lane is a body that is awake and meets only parts. It
// does not depend on other bodies, so bodies of all worlds can share lanes. moveTogether()
// (body_player.h) moves bodies that may meet each other or the player, and shapes that are not
// blocks. Part of the wide tick (wide_tick.h); host only.
#pragma once

#include "sim/body_player.h"
#include "sim/wide_body_solver.h"
#include "simd/rows.h"

namespace obby::sim {

class WideBodies {
 public:
  // `taken` is increased by the number of bodies that add() takes.
  WideBodies(const level::LevelView& level, uint64_t& taken) : level_(level), taken_(taken) {}

  // Takes bodies of a world, except those that overlap `near`, where the player can be. Returns the
  // bodies taken, one bit each. The next flush() moves them by one tick. The caller moves the
  // others first.
  uint32_t add(World& w, RigidBody* bodies, const Box& near);
  void flush();

 private:
  static constexpr int kBodies = 256, kPairs = 1024, kMoved = 256;
  static constexpr int kMaxContacts = BodyLanes::kMaxContacts;
  static constexpr uint32_t kMaxNear = 16;  // max parts near a body

  // The state of a body, as rows.
  struct alignas(64) BodyRow {
    RigidBody body;
    float radius, inverseMass;
  };
  struct alignas(64) MassRow {
    Mat3 inverseInertia;
    Vec3 center;
    int32_t restless;
    int32_t touches;  // not 0 if the body has a contact
    int32_t unused[2];
  };
  struct alignas(64) BlockRow {
    Pose pose;
    Vec3 half;
    float margin;  // max distance at which a body meets a part
  };
  static_assert(sizeof(BodyRow) == 4 * kRowWords && sizeof(MassRow) == 4 * kRowWords &&
                sizeof(BlockRow) == 4 * kRowWords);

  struct Place {  // one body of a world
    RigidBody* target;
    uint32_t collider;
    uint32_t number;  // index of the body in its world
    int firstContact, contacts;
  };
  struct Pair {  // a body and a part
    int body;
    uint32_t collider, flags;
    const void* row;     // BlockRow of the part
    const Pose* before;  // pose of a moving part a tick ago
  };
  struct MovedPart {
    BlockRow now;
    Pose before;
  };
  // The contents of geom::ManifoldT, and the materials, in two rows.
  struct alignas(64) ContactRow {
    Vec3 normal;
    int32_t count;
    geom::ManifoldPoint points[geom::kMaxPoints];
    float friction, bounce, comes;
    Vec3 surface;
    int32_t unused[6];
  };
  static_assert(sizeof(ContactRow) == 2 * 4 * kRowWords);
  struct Owner {
    World* world;
    RigidBody* bodies;
  };
  struct Counts {
    int worlds = 0, bodies = 0, pairs = 0, moved = 0;
  };

  uint32_t findApart(const RigidBody* bodies, float* speeds) const;
  bool take(const World& w, RigidBody& b, uint32_t i, float speed);
  int partsNear(Vec3 center, const Box& near, uint32_t* ids) const;
  bool takePart(const World& w, uint32_t id, const Box& near, bool& restless);
  void placeBlocks();
  void sortPairs();
  void findHits();
  void findContacts();
  void finishContact(int hit);
  void addMotion(ContactRow& row, const Pair& pair);
  WideContact contactOf(const int32_t* bodies, int k, const RigidT<WideFloat>& body) const;
  void solve();
  void solve(const int32_t* bodies, int contacts);
  void put();

  const level::LevelView& level_;
  uint64_t& taken_;
  Counts counts_;
  int hits_ = 0;
  // Unions leave the arrays uninitialised.
  union {
    Owner owners_[kBodies];  // one for each world
  };
  union {
    BodyRow bodies_[kBodies + kLanes];
  };
  union {
    MassRow masses_[kBodies];
  };
  union {
    BlockRow blocks_[kBodies + kLanes];
  };
  union {
    Place places_[kBodies];
  };
  union {
    Pair added_[kPairs];
  };
  union {
    Pair pairs_[kPairs];  // sorted
  };
  union {
    MovedPart moved_[kMoved];
  };
  // Distance and normal of each pair, then the pairs that touch.
  alignas(64) float distance_[kPairs + kLanes], normal_[3][kPairs + kLanes];
  alignas(64) int32_t touching_[kPairs + kLanes];
  union {
    ContactRow rows_[kPairs + kLanes];
  };
};

}  // namespace obby::sim
