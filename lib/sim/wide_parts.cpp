#include "sim/wide_parts.h"

#include <algorithm>

namespace obby::sim {

using F = WideFloat;

void WideParts::look(const int32_t* index) {
  const void* rows[kLanes];
  alignas(64) int32_t near[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    rows[lane] = near_.tags(index[lane]);
    near[lane] = near_.count(index[lane]);
  }
  const Rows tags = loadRows(rows);
  index_ = index;
  count_ = near[kLanes - 1];
  for (int k = 0; k < count_; ++k) {
    alignas(64) int32_t tag[kLanes];
    tags_[k] = select(load(near) > k, tags.word[k], WideInt(0));
    store(tags_[k], tag);
    for (int lane = 0; lane < kLanes; ++lane) rows[lane] = near_.rowOf(uint32_t(tag[lane]));
    blocks_[k] = blockOf(loadRows(rows));
  }
}

FloorT<F> WideParts::floorUnder(const WidePlayer& player, World* const* worlds) const {
  FloorRaysT<F> rays = makeRays(player, level_.params);
  const BoxT<F> box = boundsOf(rays);
  for (int k = 0; k < count_; ++k) {
    const WideMask asked = ((tags_[k] & int32_t(level::kSolidTag)) != 0) &
                           overlaps(boundsOf(blocks_[k].pose, blocks_[k].half), box);
    if (!any(asked)) continue;
    const WideMask upright = (tags_[k] & int32_t(level::kUprightTag)) != 0;
    if (any(asked & upright)) castAtUpright<F>(rays, blocks_[k], k, asked & upright);
    if (any(asked & !upright)) castAtTilted<F>(rays, blocks_[k], k, asked & !upright);
  }
  FloorT<F> floor = averageOf(rays, level_.params);
  addSurface(rays.nearest, worlds, floor);
  return floor;
}

// Adds friction and motion of the surfaces under the players.
void WideParts::addSurface(WideInt nearest, World* const* worlds, FloorT<F>& floor) const {
  floor.grip = level_.params.plainGrip;
  WideMask special;
  for (int k = 0; k < count_; ++k) {
    special |= (nearest == k) & ((tags_[k] & int32_t(level::kSurfaceTag)) != 0);
  }
  if (!any(special)) return;
  alignas(64) int32_t part[kLanes];
  alignas(64) float values[5][kLanes] = {};
  store(nearest, part);
  for (uint32_t left = bitsOf(special); left != 0; left &= left - 1) {
    const int lane = lowestBit(left);
    const uint32_t tag = near_.tags(index_[lane])[part[lane]], id = near_.colliderOf(tag);
    Floor one;
    surfaceMotion(*worlds[index_[lane]], nullptr, level_,
                  {{}, &near_.poseOf(tag), id, level_.bounds[id].flags}, one);
    const float found[5] = {level_.colliders[id].grip, one.velocity.x, one.velocity.y,
                            one.velocity.z, one.turning};
    for (int v = 0; v < 5; ++v) values[v][lane] = found[v];
  }
  floor.grip = select(special, load(values[0]), floor.grip);
  floor.velocity = {load(values[1]), load(values[2]), load(values[3])};
  floor.turning = load(values[4]);
}

void WideParts::findSolids(const WideMotion& motion, LaneSolids* solids) const {
  const BoxT<F> reach = bodyReach(motion, level_.params);
  for (int lane = 0; lane < kLanes; ++lane) solids[lane].count = 0;
  for (int k = 0; k < count_; ++k) {
    const WideBlock& block = blocks_[k];
    const WideMask solid = (tags_[k] & int32_t(level::kSolidTag)) != 0;
    const WideMask meets =
        solid & overlaps(boundsOf(block.pose, block.half), reach) & meetsBlock<F>(reach, block);
    for (uint32_t left = bitsOf(meets); left != 0; left &= left - 1) {
      const int lane = lowestBit(left);
      const int32_t n = solids[lane].count++;
      if (n < kLaneSolids) solids[lane].tags[n] = near_.tags(index_[lane])[k];
    }
  }
  // Very fast players need smaller steps, which only tick() takes.
  const WideMask fast = substepTravel(motion, level_.params) > safeTravel(motion, level_.params);
  for (uint32_t left = bitsOf(fast); left != 0; left &= left - 1) {
    int32_t& n = solids[lowestBit(left)].count;
    if (n > 0) n = kLaneSolids + 1;
  }
}

Obstacles WideParts::obstacles(const LaneSolids* const* solids) const {
  Obstacles o;
  alignas(64) int32_t counts[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) counts[lane] = solids[lane]->count;
  o.count = load(counts);
  o.max = *std::max_element(counts, counts + kLanes);
  for (int k = 0; k < o.max; ++k) {
    const void* rows[kLanes];
    alignas(64) int32_t upright[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const uint32_t tag = k < counts[lane] ? solids[lane]->tags[k] : 0;
      rows[lane] = near_.rowOf(tag);
      upright[lane] = int32_t(tag & level::kUprightTag);
    }
    o.block[k] = blockOf(loadRows(rows));
    o.bounds[k] = boundsOf(o.block[k].pose, o.block[k].half);
    o.upright[k] = load(upright) != WideInt(0);
  }
  return o;
}

}  // namespace obby::sim
