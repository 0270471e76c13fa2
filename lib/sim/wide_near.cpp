#include "sim/wide_near.h"

#include <algorithm>

#include "sim/wide_state.h"

namespace obby::sim {
namespace {

namespace stdx = std::experimental;

// A row of level::Bounds against the negated corners of a box: one comparison.
using Eight = stdx::simd<float, stdx::simd_abi::deduce_t<float, 8>>;

// Of a part that only tick() knows to handle.
constexpr uint32_t kSingly =
    level::kMoving | level::kVanishTimer | level::kVanishTouch | level::kConveyor | level::kTruss;

constexpr uint32_t kNoParts[1] = {0};  // an empty list

}  // namespace

void WideNear::look(World* const* worlds, int count) {
  for (int i = 0; i < count; i += kLanes) {
    const void* rows[kLanes];
    void* looks[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      rows[lane] = worlds[std::min(i + lane, count - 1)];
      looks[lane] = &looks_[i + lane];
    }
    const Rows world = loadRows(rows);
    const Vec3T<WideFloat> position = vectorAt(world, kPositionWord);
    const BoxT<WideFloat> reach =
        tickBounds<WideFloat>(position, vectorAt(world, kVelocityWord), level_.params);
    const WideInt outcome = world.word[kStateWord] & int32_t(0xff000000);
    Rows out;
    putVector(out, 0, reach.hi);
    putVector(out, 3, -reach.lo);
    out.word[6] = out.word[7] = bitsOf(WideFloat(1e38f));
    out.word[8] = cellOf<WideFloat>(level_.grid, position);
    out.word[9] = select(outcome == WideInt(0), WideInt(1), WideInt(0));
    const WideMask climbs =
        (world.word[kStateWord] & 0xff0000) == WideInt(int32_t(State::climbing) << 16);
    out.word[10] = (world.word[kFlagsWord] & 0xff00) | select(climbs, WideInt(1), WideInt(0));
    storeRows(out, looks);
  }
  // All lists are asked for before the first is read: many loads are under way at a time.
  for (int i = 0; i < count; ++i) {
    const int32_t cell = looks_[i].cell;
    lists_[i] = cell < 0 ? kNoParts : level_.grid.lists + level_.grid.cells[cell];
    __builtin_prefetch(lists_[i]);
  }
}

bool WideNear::list(int world, int index) {
  if (looks_[world].single) return false;
  const Eight reach(looks_[world].reach, stdx::element_aligned);
  const uint32_t* list = lists_[world];
  const uint32_t count = list[0];
  uint32_t found = 0, some = 0, every = ~0u;
  for (uint32_t i = 1; i <= count; i += level::kListStep) {
    if (found + level::kListStep > kRowWords) return false;
    for (uint32_t j = i; j < i + level::kListStep; ++j) {
      const level::Bounds& b = level_.bounds[list[j]];
      const bool hit = all_of(Eight(&b.lo.x, stdx::element_aligned) <= reach);
      tags_[index][found] = b.tag;
      found += hit;
      some |= hit ? b.flags : 0;
      every &= hit ? b.flags : ~0u;
    }
  }
  count_[index] = uint8_t(found);
  anyFlags_[index] = some;
  return (some & kSingly) == 0 && (every & level::kBlock) != 0;
}

}  // namespace obby::sim
