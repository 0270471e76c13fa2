#include "level/grid_build.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "base/hash.h"

namespace obby::level {
namespace {

constexpr Vec3 kCell{4, 8, 4};          // studs; about the player's reach, so that lists stay short
constexpr int64_t kMaxCells = 1 << 21;  // 8 MiB of list indices
constexpr int64_t kMaxEntries = 1 << 24;  // entries of all cells' lists, before equal lists are
                                          // merged

struct Extent {
  int32_t lo[3], hi[3];
};

class Builder {
 public:
  Builder(std::span<const Bounds> bounds, uint32_t filler, const Reach& reach)
      : bounds_(bounds), filler_(filler), reach_(reach) {}

  GridTables build() {
    cover();
    while (cellCount() > 1 && (cellCount() > kMaxCells || entryCount() > kMaxEntries)) {
      grid_.cell = grid_.cell * 1.5f;
      divide();
    }
    fill();
    return std::move(grid_);
  }

 private:
  void cover() {
    box_ = {{0, 0, 0}, {1, 1, 1}};
    for (size_t i = 0; i < bounds_.size(); ++i) {
      const Box b = reachOf(bounds_[i].box());
      box_ = i == 0 ? b : join(box_, b);
    }
    grid_.origin = box_.lo;
    grid_.cell = kCell;
    divide();
  }

  // Returns the positions of the feet from which a player can meet a collider.
  Box reachOf(const Box& b) const {
    return {b.lo - Vec3{reach_.side, reach_.up, reach_.side},
            b.hi + Vec3{reach_.side, reach_.down, reach_.side}};
  }

  void divide() {
    const Vec3 size = box_.hi - box_.lo;
    const auto cells = [](float s, float c) { return int32_t(std::min(s / c, 2e6f)) + 1; };
    grid_.nx = cells(size.x, grid_.cell.x);
    grid_.ny = cells(size.y, grid_.cell.y);
    grid_.nz = cells(size.z, grid_.cell.z);
  }

  int64_t cellCount() const { return int64_t(grid_.nx) * grid_.ny * grid_.nz; }

  Extent extentOf(const Box& bounds) const {
    const Box b = reachOf(bounds);
    const float lo[3] = {b.lo.x - box_.lo.x, b.lo.y - box_.lo.y, b.lo.z - box_.lo.z};
    const float hi[3] = {b.hi.x - box_.lo.x, b.hi.y - box_.lo.y, b.hi.z - box_.lo.z};
    const float inv[3] = {1 / grid_.cell.x, 1 / grid_.cell.y, 1 / grid_.cell.z};
    const int32_t n[3] = {grid_.nx, grid_.ny, grid_.nz};
    Extent e{};
    for (int a = 0; a < 3; ++a) {
      // A slack of 0.001 cells covers rounding at the borders.
      e.lo[a] = std::clamp(int32_t(lo[a] * inv[a] - 0.001f), 0, n[a] - 1);
      e.hi[a] = std::clamp(int32_t(hi[a] * inv[a] + 0.001f), 0, n[a] - 1);
    }
    return e;
  }

  int64_t entryCount() const {
    int64_t total = 0;
    for (const Bounds& b : bounds_) {
      const Extent e = extentOf(b.box());
      total += int64_t(e.hi[0] - e.lo[0] + 1) * (e.hi[1] - e.lo[1] + 1) * (e.hi[2] - e.lo[2] + 1);
    }
    return total;
  }

  template <class F>
  void forCells(const Extent& e, F&& f) const {
    for (int32_t z = e.lo[2]; z <= e.hi[2]; ++z) {
      for (int32_t y = e.lo[1]; y <= e.hi[1]; ++y) {
        const size_t row = (size_t(z) * size_t(grid_.ny) + size_t(y)) * size_t(grid_.nx);
        for (int32_t x = e.lo[0]; x <= e.hi[0]; ++x) f(row + size_t(x));
      }
    }
  }

  void fill() {
    const size_t cells = size_t(cellCount());
    std::vector<uint32_t> start(cells + 1, 0);
    for (const Bounds& b : bounds_) forCells(extentOf(b.box()), [&](size_t c) { ++start[c + 1]; });
    for (size_t c = 0; c < cells; ++c) start[c + 1] += start[c];
    std::vector<uint32_t> next(start.begin(), start.end() - 1), items(start[cells]);
    for (uint32_t i = 0; i < bounds_.size(); ++i) {
      forCells(extentOf(bounds_[i].box()), [&](size_t c) { items[next[c]++] = i; });
    }
    merge(start, items);
  }

  // Most cells have the same list as their neighbours, so each list is stored once.
  void merge(const std::vector<uint32_t>& start, const std::vector<uint32_t>& items) {
    std::unordered_multimap<uint64_t, uint32_t> known;
    grid_.cells.resize(start.size() - 1);
    for (size_t c = 0; c + 1 < start.size(); ++c) {
      const uint32_t count = start[c + 1] - start[c];
      const uint32_t* list = items.data() + start[c];
      const uint64_t h = hashBytes(list, count * sizeof *list);
      const auto [first, last] = known.equal_range(h);
      const auto same = std::find_if(first, last, [&](const auto& entry) {
        const uint32_t* other = grid_.lists.data() + entry.second;
        return other[0] == count &&
               (count == 0 || std::memcmp(other + 1, list, count * sizeof *list) == 0);
      });
      if (same != last) {
        grid_.cells[c] = same->second;
        continue;
      }
      uint32_t any = 0, every = ~0u;
      for (uint32_t i = 0; i < count; ++i) {
        any |= bounds_[list[i]].flags;
        every &= bounds_[list[i]].flags;
      }
      grid_.lists.insert(grid_.lists.end(), {any, every});
      grid_.cells[c] = uint32_t(grid_.lists.size());
      known.emplace(h, grid_.cells[c]);
      grid_.lists.push_back(count);
      grid_.lists.insert(grid_.lists.end(), list, list + count);
      const uint32_t filled = (count + kListStep - 1) / kListStep * kListStep;
      grid_.lists.insert(grid_.lists.end(), filled - count, filler_);
    }
  }

  const std::span<const Bounds> bounds_;
  const uint32_t filler_;
  const Reach& reach_;
  Box box_{};
  GridTables grid_;
};

}  // namespace

GridTables buildGrid(std::span<const Bounds> bounds, uint32_t filler, const Reach& reach) {
  return Builder(bounds, filler, reach).build();
}

}  // namespace obby::level
