// Estimates how far places on the ground are from the parts of a level, coarsely and fast.
#pragma once

#include <cstddef>
#include <vector>

#include "import/draft/draft.h"

namespace obby::importer {

// A rectangle in x and z, in studs.
struct GroundArea {
  float x0 = 0, x1 = 0, z0 = 0, z1 = 0;
};

class PartDistance {
 public:
  // Answers queries in `whole`. A part outside counts as at its border.
  PartDistance(const std::vector<PartDraft>& parts, GroundArea whole);

  // Returns the studs from the nearest point of the area to the nearest part, ignoring height. The
  // error is about one square: a 256th of the longer side of `whole`, at least 32 studs. Without
  // parts, all places get the same distance.
  float of(const GroundArea& area) const;

 private:
  struct Span {
    size_t x0, x1, z0, z1;  // inclusive
  };
  Span spanOf(const GroundArea& area) const;
  void spread();

  GroundArea whole_;
  float step_ = 1;
  size_t width_ = 1, depth_ = 1;
  std::vector<int> distances_;  // fifths of a square's side
};

}  // namespace obby::importer
