// Boxes seen from above, and fewer and larger boxes instead of many.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

// Studs between two boxes seen from above.
inline float gapBetween(const Box& a, const Box& b) {
  const float x = maxf(maxf(a.lo.x - b.hi.x, b.lo.x - a.hi.x), 0.0f);
  const float z = maxf(maxf(a.lo.z - b.hi.z, b.lo.z - a.hi.z), 0.0f);
  return sqrtf32(x * x + z * z);
}

inline bool isWithin(const Box& inner, const Box& outer) {
  const Box all = join(inner, outer);
  return all.lo == outer.lo && all.hi == outer.hi;
}

// Joins boxes that are near each other, until there are at most `most`, above 8.
inline std::vector<Box> fewBoxes(std::vector<Box> boxes, size_t most) {
  for (float size = 64; boxes.size() > most; size *= 2) {  // studs: of blocks of space
    std::map<std::array<float, 3>, Box> blocks;
    for (const Box& box : boxes) {
      const Vec3 at = (box.lo + box.hi) * (0.5f / size);
      const std::array<float, 3> key{std::floor(at.x), std::floor(at.y), std::floor(at.z)};
      const auto known = blocks.find(key);
      if (known == blocks.end()) {
        blocks.emplace(key, box);
      } else {
        known->second = join(known->second, box);
      }
    }
    boxes.clear();
    for (const auto& block : blocks) boxes.push_back(block.second);
  }
  return boxes;
}

}  // namespace obby::solve
