// Alternating safe and deadly tiles, crossed by hops from corner to corner. At higher difficulty
// more tiles are deadly, until one route is left.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"rows", "", 3, 5, 1, 12, "number of rows of three tiles"},
    {"tile", "studs", 7, 4.5f, 3, 12, "size of a tile"},
    {"taken", "", 0, 0.9f, 0, 1, "share of the safe tiles off the route that become deadly"},
};
const auto& [kRows, kTile, kTaken] = kParameters;

void build(Sketch& s) {
  constexpr int kFiles = 3;
  constexpr float kLower = 0.2f;  // deadly tiles lie a little lower, so that their edges are
                                  // visible
  const uint32_t rows = s.mixCount(kRows);
  const float tile = s.mix(kTile), taken = s.steady(kTaken);
  int safeFile = s.below(2) == 0 ? 0 : 2;  // column of the tile that stays safe
  for (uint32_t row = 0; row < rows; ++row) {
    for (int file = 0; file < kFiles; ++file) {
      const bool spared = (file - safeFile) % 2 == 0 && !s.chance(taken);
      const bool safe = file == safeFile || spared;
      const float down = safe ? 0 : kLower;
      PartSketch& p = s.part(safe ? "Tile" : "Deadly tile",
                             {tile * float(file - 1), -0.5f - down, tile / 2}, {tile, 1, tile});
      if (safe) {
        p.color = s.shade();
      } else {
        Sketch::deadly(p);
      }
    }
    safeFile = safeFile == 1 ? (s.below(2) == 0 ? 0 : 2) : 1;
    s.advance(tile);
    s.expectJumps(1);
  }
  s.expectRoute(tile * float(rows) / 2);
  // The strip prevents a jump from a corner straight to the landing.
  s.floor("Strip", 5, tile * kFiles);
}

}  // namespace

constinit const Style kCheckerboardStyle{.name = "checkerboard",
                                         .description = "safe and deadly tiles in turn",
                                         .build = build,
                                         .parameters = kParameters};

}  // namespace obby::gen
