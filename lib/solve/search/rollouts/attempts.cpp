#include "solve/search/rollouts/attempts.h"

#include <algorithm>

#include "solve/search/archive/cell.h"

namespace obby::solve {

namespace {

constexpr size_t kMaxKinds = 4096;
constexpr float kPlace = 6;          // studs; ends in a cube of this size count as the same place
constexpr float kOtherOutcome = 40;  // studs; the distance that a different outcome stands for

uint64_t kindOf(const AttemptEnd& end) {
  const auto place = [](float v) { return uint64_t(uint32_t(floorToInt(v / kPlace)) & 0xffffu); };
  const Vec3 p = end.position;
  return place(p.x) | place(p.y) << 16 | place(p.z) << 32 | uint64_t(end.outcome) << 48;
}

float apart(const AttemptEnd& a, const AttemptEnd& b) {
  return length(a.position - b.position) + (a.outcome != b.outcome ? kOtherOutcome : 0.0f);
}

}  // namespace

bool Attempts::show(const AttemptEnd& end) {
  if (ends_.size() >= kMaxKinds || !kinds_.insert(kindOf(end)).second) return false;
  ends_.push_back(end);
  return true;
}

std::vector<EndCount> Attempts::counts() const {
  std::vector<EndCount> result;
  for (const auto& [kind, count] : counts_) result.push_back({kind.first, kind.second, count});
  std::stable_sort(result.begin(), result.end(),
                   [](const EndCount& a, const EndCount& b) { return a.count > b.count; });
  return result;
}

std::vector<AttemptEnd> Attempts::newestFailures(size_t count) const {
  std::vector<AttemptEnd> result;
  for (size_t i = ends_.size(); i-- > 0 && result.size() < count;) {
    if (ends_[i].outcome != sim::Outcome::running) result.push_back(ends_[i]);
  }
  return result;
}

std::vector<AttemptEnd> Attempts::sample(size_t count, Vec3 near) const {
  std::vector<AttemptEnd> result;
  if (ends_.empty() || count == 0) return result;
  size_t next = 0;
  for (size_t i = 1; i < ends_.size(); ++i) {
    if (length(ends_[i].position - near) < length(ends_[next].position - near)) next = i;
  }
  std::vector<float> free(ends_.size(), 1e30f);  // distance to the nearest chosen one
  while (result.size() < std::min(count, ends_.size())) {
    result.push_back(ends_[next]);
    const AttemptEnd& chosen = result.back();
    for (size_t i = 0; i < ends_.size(); ++i) free[i] = std::min(free[i], apart(ends_[i], chosen));
    next = size_t(std::max_element(free.begin(), free.end()) - free.begin());
    if (free[next] <= 0) break;
  }
  return result;
}

}  // namespace obby::solve
