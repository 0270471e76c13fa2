#include "solve/proof/crowding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "sim/candidates.h"
#include "solve/proof/few_boxes.h"
#include "solve/proof/flight.h"
#include "solve/proof/supports.h"

namespace obby::solve {

namespace {

constexpr float kRounding = 0.125f;               // studs
constexpr float kFinest = 0.5f;                   // studs: a place is not divided further
constexpr size_t kMostCrowdingWork = 20'000'000;  // parts looked at; from then on whole cells count
constexpr size_t kMostPlaces = 256;

bool isCrowd(size_t parts, size_t moving) {
  return parts > size_t(sim::kMaxCandidates) || moving > size_t(sim::kMaxMovingCandidates);
}

// How far around its feet a player looks for parts, at the highest speed there is. Push-out turns
// speed aside, and off slopes a fall too, before anything bounds it.
Box farthestLook(const level::LevelView& level) {
  Params p = level.params;
  p.jumpSpeed = fastestJump(level);
  float side = 1.42f * level.maxSideSpeed, up = p.maxFallSpeed + p.jumpSpeed;
  const bool slopes =
      std::any_of(level.bounds, level.bounds + level.colliderCount, [](const level::Bounds& b) {
        return (b.flags & level::kSolid) != 0 && (b.flags & level::kUpright) == 0;
      });
  if (slopes) side = up = length(Vec3{side, up, 0});
  const Box look = sim::tickBounds<float>(Vec3{}, Vec3{side, up, side}, p);
  return grow(look, {kRounding, kRounding, kRounding});
}

class Crowds {
 public:
  explicit Crowds(const level::LevelView& level)
      : level_(level), grid_(level.grid), look_(farthestLook(level)) {}

  std::vector<Box> find() {
    const std::vector<bool> isLong = longLists();
    if (isLong.empty()) return {};
    size_t cell = 0;
    for (int32_t z = 0; z < grid_.nz; ++z) {
      for (int32_t y = 0; y < grid_.ny; ++y) {
        for (int32_t x = 0; x < grid_.nx; ++x, ++cell) {
          const uint32_t at = grid_.cells[cell];
          if (isLong[at]) lookInto(cellAt(x, y, z), grid_.lists + at);
        }
      }
    }
    return std::move(found_);
  }

 private:
  // By where they begin: lists of more parts than a player looks at. Empty: there are none.
  std::vector<bool> longLists() const {
    std::vector<bool> isLong;
    for (uint32_t at = 0; at < grid_.listWords;) {
      const uint32_t* const list = grid_.lists + at;
      const uint32_t count = list[0];
      if (isCrowd(count, movingOf(list))) {
        isLong.resize(grid_.listWords, false);
        isLong[at] = true;
      }
      at += 1 + (count + level::kListStep - 1) / level::kListStep * level::kListStep;
    }
    return isLong;
  }

  bool moves(uint32_t id) const { return (level_.bounds[id].flags & level::kMoving) != 0; }

  size_t movingOf(const uint32_t* list) const {
    if (level_.moverCount == 0) return 0;
    return size_t(
        std::count_if(list + 1, list + 1 + list[0], [&](uint32_t id) { return moves(id); }));
  }

  Box cellAt(int32_t x, int32_t y, int32_t z) const {
    const Vec3 i = grid_.inverseCell, size{1 / i.x, 1 / i.y, 1 / i.z};
    const Vec3 lo = grid_.origin + mul(size, Vec3{float(x), float(y), float(z)});
    return grow(Box{lo, lo + size}, {kRounding, kRounding, kRounding});
  }

  void lookInto(const Box& cell, const uint32_t* list) {
    if (work_ > kMostCrowdingWork) {
      found_.push_back(cell);
      return;
    }
    isCrowded_ = false;
    divide(cell, std::vector<uint32_t>(list + 1, list + 1 + list[0]));
    if (isCrowded_) found_.push_back(crowded_);
  }

  // Notes where in `feet` more of the parts are near than are looked at.
  void divide(const Box& feet, const std::vector<uint32_t>& parts) {
    work_ += parts.size();
    std::vector<uint32_t> near;
    size_t moving = 0, always = 0, movingAlways = 0;
    for (const uint32_t id : parts) {
      const Box part = level_.bounds[id].box();
      const Box from{part.lo - look_.hi, part.hi - look_.lo};  // feet from where it is near
      if (!overlaps(from, feet)) continue;
      near.push_back(id);
      const size_t one = moves(id) ? 1 : 0;
      moving += one;
      if (!isWithin(feet, from)) continue;
      ++always;
      movingAlways += one;
    }
    if (!isCrowd(near.size(), moving)) return;
    const Vec3 size = feet.hi - feet.lo;
    const float longest = std::max({size.x, size.y, size.z});
    if (isCrowd(always, movingAlways) || longest <= kFinest || work_ > kMostCrowdingWork) {
      crowded_ = isCrowded_ ? join(crowded_, feet) : feet;
      isCrowded_ = true;
      return;
    }
    Box lower = feet, upper = feet;
    const Vec3 middle = (feet.lo + feet.hi) * 0.5f;
    if (longest == size.x) {
      lower.hi.x = upper.lo.x = middle.x;
    } else if (longest == size.y) {
      lower.hi.y = upper.lo.y = middle.y;
    } else {
      lower.hi.z = upper.lo.z = middle.z;
    }
    divide(lower, near);
    divide(upper, near);
  }

  const level::LevelView& level_;
  const level::Grid& grid_;
  const Box look_;
  size_t work_ = 0;
  bool isCrowded_ = false;  // the cell that is looked into: somewhere within `crowded_`
  Box crowded_;
  std::vector<Box> found_;
};

}  // namespace

std::vector<Box> crowdedPlaces(const level::LevelView& level) {
  return fewBoxes(Crowds(level).find(), kMostPlaces);
}

}  // namespace obby::solve
