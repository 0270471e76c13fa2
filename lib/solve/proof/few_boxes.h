// Fewer and larger boxes instead of many.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

// One more box; where there are `most` already, above 0, it is joined with the last. Gives what
// became of it.
inline const Box& addBox(std::vector<Box>& boxes, const Box& box, size_t most) {
  if (boxes.size() < most) {
    boxes.push_back(box);
  } else {
    boxes.back() = join(boxes.back(), box);
  }
  return boxes.back();
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
