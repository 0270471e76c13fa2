// The tables of turns of a level, each stored once, since many parts of a course may spin at one
// rate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "level/motion_tables.h"

namespace obby::level {

// A table of turns. Valid while the store, or the store that it was moved to, lives.
struct SpinTurns {
  std::span<const Mat3> rows;  // empty if the part does not turn
  bool upright = false;        // true if all rows leave local Y exactly unchanged
};

class SpinStore {
 public:
  // Returns the turns of a spin. With `upright`, turns that change local Y only by rounding are
  // snapped, so that they leave it exactly unchanged.
  SpinTurns of(const SpinPlan& plan, bool upright);

  size_t rows() const { return rows_; }  // rows of all tables together

 private:
  std::span<const Mat3> kept(std::vector<Mat3> rows);

  std::unordered_map<std::string, SpinTurns> known_;  // keys are the bytes of the plans
  std::unordered_multimap<uint64_t, std::span<const Mat3>> tablesByDigest_;
  std::deque<std::vector<Mat3>> tables_;
  size_t rows_ = 0;
};

}  // namespace obby::level
