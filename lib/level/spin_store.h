// The tables of turns of a level, each of them once: whole courses spin at one rate.
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

// A table of turns. Valid while the store, or what it was moved to, lives.
struct SpinTurns {
  std::span<const Mat3> rows;  // none: it does not turn
  bool upright = false;        // local Y stays where it is in all rows, exactly
};

class SpinStore {
 public:
  // `upright`: where the turns leave local Y where it is but for rounding, they are to do so
  // exactly.
  SpinTurns of(const SpinPlan& plan, bool upright);

  size_t rows() const { return rows_; }  // of all tables together

 private:
  std::span<const Mat3> kept(std::vector<Mat3> rows);

  std::unordered_map<std::string, SpinTurns> known_;  // by the bytes of what they are made from
  std::unordered_multimap<uint64_t, std::span<const Mat3>> tablesByDigest_;
  std::deque<std::vector<Mat3>> tables_;
  size_t rows_ = 0;
};

}  // namespace obby::level
