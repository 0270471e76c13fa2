#include "level/spin_store.h"

#include <array>
#include <cstring>
#include <utility>

#include "base/hash.h"
#include "level/upright.h"

namespace obby::level {
namespace {

// Returns the bytes of everything that spinTable() reads; the speed counts only through its rows.
// Plans that make equal tables have equal bytes, except for the sign of a zero.
std::string bytesOf(const SpinPlan& plan, bool upright) {
  const std::array<double, 8> parts{double(plan.axis.x),      double(plan.axis.y),
                                    double(plan.axis.z),      plan.turns,
                                    double(plan.rows),        plan.speed < 0 ? -1.0 : 1.0,
                                    plan.speed * plan.offset, upright ? 1.0 : 0.0};
  std::string bytes(sizeof parts, '\0');
  std::memcpy(bytes.data(), parts.data(), sizeof parts);
  return bytes;
}

}  // namespace

SpinTurns SpinStore::of(const SpinPlan& plan, bool upright) {
  if (plan.rows == 0) return {{}, upright};
  const auto [known, isNew] = known_.try_emplace(bytesOf(plan, upright));
  if (!isNew) return known->second;
  std::vector<Mat3> rows = spinTable(plan);
  const bool stands = upright && makeUpright(rows);
  known->second = {kept(std::move(rows)), stands};
  return known->second;
}

// Returns the stored table with these rows. Adds them if there is none.
std::span<const Mat3> SpinStore::kept(std::vector<Mat3> rows) {
  const size_t bytes = rows.size() * sizeof(Mat3);
  const uint64_t digest = hashBytes(rows.data(), bytes);
  const auto [first, last] = tablesByDigest_.equal_range(digest);
  for (auto it = first; it != last; ++it) {
    const std::span<const Mat3> known = it->second;
    if (known.size() == rows.size() && std::memcmp(known.data(), rows.data(), bytes) == 0)
      return known;
  }
  rows_ += rows.size();
  tables_.push_back(std::move(rows));
  const std::span<const Mat3> added(tables_.back());
  tablesByDigest_.emplace(digest, added);
  return added;
}

}  // namespace obby::level
