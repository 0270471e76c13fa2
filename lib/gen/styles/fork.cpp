// Two or three routes of different kinds, side by side.
#include <algorithm>

#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"stone", "studs", 6, 4, 2, 12, "size of a stone"},
    {"beamWidth", "studs", 3, 1, 0.5f, 8, "width of the beam"},
    {"laneWidth", "studs", 8, 5, 2, 12, "width of the lane with hurdles"},
    {"hurdle", "studs", 1, 4.5f, 0.5f, 6,
     "height of a hurdle; at most 0.7 of the height of a jump"},
    {"hillWidth", "studs", 8, 5, 2, 12, "width of the hill"},
};
const auto& [kStone, kBeamWidth, kLaneWidth, kHurdle, kHillWidth] = kParameters;

constexpr float kLong = 36, kApart = 15;
constexpr float kSlide = 5;  // studs/s that a player gains on a slope

void stones(Sketch& s, float right) {
  const float size = s.mix(kStone), max = s.sideGap(0.9f);
  // Places enough stones that no gap exceeds `max`, as far as they fit.
  const uint32_t count =
      std::min(uint32_t((kLong - max) / (size + max)) + 1, uint32_t(kLong / size));
  const float gap = (kLong - size * float(count)) / float(count + 1);
  for (uint32_t i = 0; i < count; ++i) {
    const float ahead = gap + size / 2 + (size + gap) * float(i);
    s.part("Stone", {right, -0.5f, ahead}, {size, 1, size}).colored(s.shade());
  }
  s.expectJumps(count + 1);
}

void beam(Sketch& s, float right) {
  s.part("Beam", {right, -0.5f, kLong / 2}, {s.mix(kBeamWidth), 1, kLong}).colored(colors::kWood);
}

void hurdles(Sketch& s, float right) {
  const float width = s.mix(kLaneWidth), high = minf(s.mix(kHurdle), s.reach().apex() * 0.7f);
  s.part("Lane", {right, -0.5f, kLong / 2}, {width, 1, kLong}).colored(s.shade());
  for (int i = 0; i < 3; ++i) {
    Sketch::deadly(s.wall("Hurdle", right, 8 + 10 * float(i), width, high, 1));
  }
  s.expectJumps(3);
}

void hill(Sketch& s, float right) {
  const float width = s.mix(kHillWidth), up = maxf(s.reach().rise() * 0.5f, 1.0f), half = kLong / 2;
  s.part("Hill up", {right, up / 2, half / 2}, {width, up, half})
      .shaped(schema::Shape::WEDGE)
      .turned(kAbout)
      .colored(s.shade());
  s.part("Hill down", {right, up / 2, half * 1.5f}, {width, up, half})
      .shaped(schema::Shape::WEDGE)
      .colored(s.shade());
}

using BuildRoute = void (*)(Sketch&, float right);
constexpr BuildRoute kRoutes[] = {stones, beam, hurdles, hill};
constexpr uint32_t kRouteCount = sizeof(kRoutes) / sizeof(kRoutes[0]);

void build(Sketch& s) {
  const uint32_t routes = 2 + s.below(2), first = s.below(kRouteCount);
  const float width = kApart * float(routes - 1) + 8, left = -kApart * float(routes - 1) / 2;
  // Offset to the right of the middle or right-hand route, studs.
  const float offset = left + kApart * float(routes / 2);
  s.floor("Crossing", 6, width);
  s.via({offset, 0, -3});
  for (uint32_t i = 0; i < routes; ++i) {
    kRoutes[(first + i) % kRouteCount](s, left + kApart * float(i));
  }
  s.advance(kLong);
  s.floor("Junction", 6, width);
  s.via({offset, 0, -3});
  s.noteCarrier(kSlide);
  s.expectRoute(width);
}

}  // namespace

constinit const Style kForkStyle{.name = "fork",
                                 .description = "several routes side by side",
                                 .build = build,
                                 .parameters = kParameters,
                                 .wide = true};

}  // namespace obby::gen
