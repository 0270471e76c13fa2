// Indexes the positions of the parts of Workspace, for scripts' spatial queries and for touches.
// Lists are in the order of the ids. Private to lib/engine.
#pragma once

#include <cstdint>
#include <set>
#include <unordered_map>
#include <vector>

#include "geom/shape.h"
#include "math/vec.h"

namespace obby::engine {

class Scenery {
 public:
  struct Part {
    Pose pose;
    Vec3 half;
    geom::ShapeKind shape = geom::ShapeKind::block;
    bool collides = true;
    bool listened = false;  // a script listens to its touches
    bool limb = false;
  };
  struct RayHit {
    uint32_t id;
    float share;  // fraction of the ray
    Vec3 normal;
  };

  void add(uint32_t id, const Part& part);
  void remove(uint32_t id);
  Part* find(uint32_t id);
  // Records a change of the part's pose or size.
  void moved(uint32_t id);

  std::vector<uint32_t> overlaps(const Pose& frame, Vec3 half) const;
  std::vector<uint32_t> overlapsOfPart(uint32_t id) const;
  std::vector<RayHit> castRay(Vec3 origin, Vec3 direction) const;
  // Returns the distance from a point to the part's box; 0 inside.
  float distance(uint32_t id, Vec3 point) const;
  // Finds the parts with listeners that the limb touches. If the limb is `listened`, it finds all
  // parts, since the limb's own listeners receive each touch. Returns false if no limb and no part
  // with listeners has moved in this frame.
  bool contacts(uint32_t limb, std::vector<uint32_t>& out);
  // Ends a frame. Call it after contacts() of every limb.
  void settle() { moved_.clear(); }

 private:
  std::vector<uint32_t> sorted(const Box& bounds) const;

  std::unordered_map<uint32_t, Part> parts_;
  std::set<uint32_t> listened_, moved_;
};

}  // namespace obby::engine
