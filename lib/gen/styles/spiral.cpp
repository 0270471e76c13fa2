// Ledges that wind around a core, half or one and a half times, as in tower obbies.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"size", "studs", 5, 3, 2, 8, "size of a ledge"},
    {"foot", "studs", 10, 6, 3, 20, "width of the floor before the ledges"},
    {"gap", "studs", 1, 5, 0, 6, "distance from ledge to ledge"},
    {"edge", "studs", 0, 1, 0, 3, "distance from the last ledge to the landing"},
    {"landing", "studs", 8, 5, 2, 20, "width of the landing"},
};
const auto& [kSize, kFoot, kGap, kEdge, kLanding] = kParameters;

// Core diameter; distance from the core's side to the ledges' centers; studs.
constexpr float kCore = 8, kBehind = 6;
constexpr float kRadius = kCore / 2 + kBehind;
// Share of the highest reachable ledge, since the jump also goes round a corner.
constexpr float kShare = 0.7f;

// Returns the turns around the core between ledges with gaps of about `gap` studs.
float stepOf(float size, float gap) {
  const float chord = (size + gap) / (2 * kRadius);
  return chord < 0.5f ? chord / kPi : 1.0f / 6;
}

void build(Sketch& s) {
  const float size = s.mix(kSize), foot = 6, side = s.side();
  s.floor("Foot", foot, s.mix(kFoot));
  const float round = s.chance(0.5f) ? 0.5f : 1.5f;
  const float max = 0.6f * s.reach().gap(s.reach().rise() * kShare);
  const float step = stepOf(size, minf(s.mix(kGap), max));
  const uint32_t last = uint32_t(round / step + 0.5f);
  const float middle = 1 + size / 2 + kRadius;  // distance of the core's axis ahead
  float height = 0;
  for (uint32_t i = 0; i <= last; ++i) {
    const SinCos a = sinCos(turnsFromRadians(2 * kPi * side * round * float(i) / float(last)));
    const Vec3 at{kRadius * a.sin, height += s.rise(kShare), middle - kRadius * a.cos};
    s.part("Ledge", {at.x, at.y - 0.5f, at.z}, {size, 1, size}).colored(s.shade());
    s.via(at);
  }
  s.part("Core", {0, height / 2, middle}, {kCore, height + 1, kCore}).colored(colors::kWall);
  s.advance(middle + kRadius + size / 2, height);
  s.expectRoute(2 * kPi * kRadius * round);
  const float gap = s.mix(kEdge), wide = s.mix(kLanding);
  s.floor("Landing", 5, wide, gap);
}

}  // namespace

constinit const Style kSpiralStyle{.name = "spiral",
                                   .description = "ledges that wind up around a core",
                                   .build = build,
                                   .parameters = kParameters,
                                   .wide = true};

}  // namespace obby::gen
