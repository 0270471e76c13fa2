#include "solve/solutions.h"

#include <algorithm>

namespace obby::solve {

namespace {

bool shorter(const Playthrough& a, const Playthrough& b) {
  return a.ticks < b.ticks || (a.ticks == b.ticks && a.end.jumps < b.end.jumps);
}

bool strays(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance) {
  return std::any_of(a.begin(), a.end(), [&](Vec3 p) {
    return std::none_of(b.begin(), b.end(), [&](Vec3 q) {
      const Vec3 d = p - q;
      return dot(d, d) <= distance * distance;
    });
  });
}

}  // namespace

bool pathsDiffer(const std::vector<Vec3>& a, const std::vector<Vec3>& b, float distance) {
  return strays(a, b, distance) || strays(b, a, distance);
}

size_t Solutions::similar(const Playthrough& p) const {
  return size_t(std::find_if(all_.begin(), all_.end(),
                             [&](const Playthrough& other) {
                               return !pathsDiffer(p.path, other.path, kDistinct);
                             }) -
                all_.begin());
}

bool Solutions::wants(const Playthrough& p) const {
  const size_t i = similar(p);
  return i == all_.size() || shorter(p, all_[i]);
}

void Solutions::add(Playthrough p) {
  const size_t i = similar(p);
  if (i < all_.size()) all_.erase(all_.begin() + std::ptrdiff_t(i));
  all_.insert(std::upper_bound(all_.begin(), all_.end(), p, shorter), std::move(p));
}

}  // namespace obby::solve
