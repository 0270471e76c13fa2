#include "gen/route_cursor.h"

namespace obby::gen {

Vec3 RouteCursor::direction(Vec3 local) const {
  const SinCos a = sinCos(heading_);
  const Vec3 forward = directionOf(a), right{a.cos, 0, -a.sin};
  return right * local.x + Vec3{0, local.y, 0} + forward * local.z;
}

Vec3 RouteCursor::at(Vec3 from) const { return edge_ + direction(from); }

Quat RouteCursor::facing() const {
  const SinCos half = sinCos(Turns(int16_t(heading_) / 2));
  return {0, half.sin, 0, half.cos};
}

void RouteCursor::advance(float forward, float up, float right) {
  edge_ = at({right, up, forward});
  along_ += absf(forward) + absf(right) + (up > 0 ? up : 0);
}

void RouteCursor::turnAbout(float diameter, Turns heading) {
  const Vec3 middle = at({0, 0, -diameter / 2});
  heading_ = heading;
  turned_ = true;
  edge_ = middle;
  edge_ = at({0, 0, diameter / 2});
}

}  // namespace obby::gen
