// Safe and deadly tiles in turn: hops from corner to corner, or along a row.
#include "gen/styles/all.h"

namespace obby::gen {

void buildCheckerboard(Sketch& s) {
  constexpr int kFiles = 3;
  constexpr float kLower = 0.2f;  // deadly tiles lie a little lower: their edges are seen
  const uint32_t rows = s.mixCount(3, 5);
  const float tile = s.mix(7, 4.5f);
  for (uint32_t row = 0; row < rows; ++row) {
    for (int file = 0; file < kFiles; ++file) {
      const bool safe = (row + uint32_t(file)) % 2 == 1;
      const float down = safe ? 0 : kLower;
      PartSketch& p = s.part(safe ? "Tile" : "Deadly tile",
                             {tile * float(file - 1), -0.5f - down, tile / 2}, {tile, 1, tile});
      if (safe) {
        p.color = s.shade();
      } else {
        Sketch::deadly(p);
      }
    }
    s.advance(tile);
    s.expectJumps(1);
  }
  s.expectWay(tile * float(rows) / 2);
  // Not from a corner straight on to the landing.
  s.floor("Strip", 5, tile * kFiles);
}

}  // namespace obby::gen
