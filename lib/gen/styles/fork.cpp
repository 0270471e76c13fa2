// Two or three routes side by side, of different kinds.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr float kLong = 36, kApart = 15;
constexpr float kSlide = 5;  // studs/s that a player gains on a slope

void stones(Sketch& s, float right) {
  const float size = s.mix(6, 4), most = s.sideGap(0.9f);
  const uint32_t count = uint32_t((kLong - most) / (size + most)) + 1;
  const float gap = (kLong - size * float(count)) / float(count + 1);
  for (uint32_t i = 0; i < count; ++i) {
    const float ahead = gap + size / 2 + (size + gap) * float(i);
    s.part("Stone", {right, -0.5f, ahead}, {size, 1, size}).colored(s.shade());
  }
  s.expectJumps(count + 1);
}

void beam(Sketch& s, float right) {
  s.part("Beam", {right, -0.5f, kLong / 2}, {s.mix(3, 1), 1, kLong}).colored(colors::kWood);
}

void hurdles(Sketch& s, float right) {
  const float width = s.mix(8, 5), high = minf(s.mix(1, 4.5f), s.reach().apex() * 0.7f);
  s.part("Lane", {right, -0.5f, kLong / 2}, {width, 1, kLong}).colored(s.shade());
  for (int i = 0; i < 3; ++i) {
    Sketch::deadly(s.wall("Hurdle", right, 8 + 10 * float(i), width, high, 1));
  }
  s.expectJumps(3);
}

void hill(Sketch& s, float right) {
  const float width = s.mix(8, 5), up = maxf(s.reach().rise() * 0.5f, 1.0f), half = kLong / 2;
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

}  // namespace

void buildFork(Sketch& s) {
  const uint32_t routes = 2 + s.below(2), first = s.below(kRouteCount);
  const float width = kApart * float(routes - 1) + 8, left = -kApart * float(routes - 1) / 2;
  s.floor("Crossing", 6, width);
  for (uint32_t i = 0; i < routes; ++i) {
    kRoutes[(first + i) % kRouteCount](s, left + kApart * float(i));
  }
  s.advance(kLong);
  s.floor("Junction", 6, width);
  s.noteCarrier(kSlide);
  s.expectWay(width);
}

}  // namespace obby::gen
